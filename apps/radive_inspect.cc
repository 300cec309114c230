// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <optional>
#include <string>

#include "apps/app_main.h"
#include "radive/config/load_config.h"
#include "radive/pipeline/input_report.h"
#include "radive/util/json.h"

DEFINE_string(config, "", "YAML file with the settings of the dataset, see configs/.");
DEFINE_string(set,
              "",
              "Settings that win over --config: stage.field=value, separated by commas; commas "
              "inside brackets belong to the value.");
DEFINE_bool(json, false, "Print one JSON object instead of a block of text.");

namespace {

int Fail(const std::string& error) {
  if (FLAGS_json) {
    std::fputs(radive::JsonText({{"error", error}}).c_str(), stdout);
  }
  std::fprintf(stderr, "radive_inspect: %s\n", error.c_str());
  return radive::Code(radive::ExitStatus::kFailure);
}

}  // namespace

int main(int argc, char** argv) {
  radive::InitApp(&argc,
                  &argv,
                  "Says what a dataset folder, bag or point file holds, without running odometry.\n"
                  "  radive_inspect PATH [--config=configs/DATASET.yaml] [--json]",
                  /*max_arguments=*/1);
  if (argc < 2)
    return Fail("the path of a dataset folder, bag or point file is missing; see --help");
  std::string error;
  const auto config = radive::LoadRunConfig(FLAGS_config, FLAGS_set, &error);
  if (!config) return Fail(error);
  const std::optional<radive::InputReport> report = radive::InspectInput(
      argv[1], config->input, config->odometry.sensor, config->odometry.preprocessing, &error);
  if (!report) return Fail(error);
  std::fputs((FLAGS_json ? report->ToJson() : report->ToText()).c_str(), stdout);
  return radive::EndApp(radive::ExitStatus::kSuccess);
}
