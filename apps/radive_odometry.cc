// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "apps/app_main.h"
#include "radive/config/describe_config.h"
#include "radive/config/load_config.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/pipeline/input_report.h"
#include "radive/pipeline/run_sequence.h"
#include "radive/pipeline/thinned_source.h"
#include "radive/util/exit_status.h"

DEFINE_string(input, "", "Dataset folder or scan folder. Required.");
DEFINE_string(config,
              "",
              "YAML file with the settings that differ from the defaults, see configs/.");
DEFINE_string(output,
              "",
              "Folder for the results: new, empty, or with earlier results to replace. Required.");
DEFINE_string(reference,
              "",
              "Ground truth, a file or a folder: the scores are printed and go to scores.json; how "
              "it is read and matched is set in reference.*.");
DEFINE_string(set,
              "",
              "Settings that win over --config: stage.field=value, separated by commas; commas "
              "inside brackets belong to the value.");
DEFINE_int32(start, 0, "Scans to leave out at the beginning.");
DEFINE_int32(frames, -1, "Scans to run over; -1: all.");
DEFINE_int32(threads, 1, "Threads; the results do not depend on it.");
DEFINE_bool(help_config, false, "Print every setting with its unit, default and meaning, and end.");
DEFINE_bool(quiet, false, "No progress and remarks on stderr; errors are still printed.");

namespace {

using radive::ExitStatus;

std::atomic<bool> stop{false};

// The first signal asks the run to finish its files; the second ends the program at once.
extern "C" void HandleSignal(int signal_number) {
  stop.store(true);
  std::signal(signal_number, SIG_DFL);
}

// As a shell would take it: arguments with anything unusual in them are quoted.
std::string CommandLine(int argc, char** argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool is_plain = argument.find_first_of(" \t\n\"'\\$*?[](){}<>|&;`#") == std::string::npos;
    line += (i == 0 ? "" : " ") + (is_plain ? argument : "'" + argument + "'");
  }
  return line;
}

int Fail(const std::string& error) {
  std::fprintf(stderr, "radive_odometry: %s\n", error.c_str());
  return radive::Code(ExitStatus::kFailure);
}

std::string FlagError() {
  if (FLAGS_input.empty()) return "--input is missing; see --help";
  if (FLAGS_output.empty()) return "--output is missing; see --help";
  if (FLAGS_start < 0) return "--start must be >= 0, is " + std::to_string(FLAGS_start);
  if (FLAGS_frames < -1) return "--frames must be >= 0, or -1, is " + std::to_string(FLAGS_frames);
  if (FLAGS_threads < 1) return "--threads must be >= 1, is " + std::to_string(FLAGS_threads);
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command_line = CommandLine(argc, argv);
  radive::InitApp(
      &argc,
      &argv,
      "Radar odometry over one sequence: a 6-DoF trajectory from radar scans.\n"
      "  radive_odometry --input=SEQUENCE --config=configs/DATASET.yaml --output=RESULTS");
  if (FLAGS_help_config) {
    std::fputs(radive::DescribeConfig().c_str(), stdout);
    return radive::EndApp(ExitStatus::kSuccess);
  }
  std::string error = FlagError();
  if (!error.empty()) return Fail(error);
  auto config = radive::LoadRunConfig(FLAGS_config, FLAGS_set, &error);
  if (!config) return Fail(error);
  config->odometry.num_threads = FLAGS_threads;
  auto source = radive::OpenScanSource(FLAGS_input, config->input, &error);
  if (source == nullptr) return Fail(error);
  if (const radive::PerturbationOptions& perturbation = config->perturbation;
      perturbation.drop > 0.0) {
    source = std::make_unique<radive::ThinnedSource>(
        std::move(source), perturbation.drop, perturbation.seed);
  }
  if (!FLAGS_quiet) {
    const auto report = radive::InspectInput(FLAGS_input,
                                             config->input,
                                             config->odometry.sensor,
                                             config->odometry.preprocessing,
                                             &error);
    if (!report) return Fail(error);
    std::fputs(report->ToText().c_str(), stderr);
  }

  std::signal(SIGINT, HandleSignal);
  std::signal(SIGTERM, HandleSignal);
  radive::RunRequest request;
  request.input = FLAGS_input;
  request.output = FLAGS_output;
  request.reference = FLAGS_reference;
  request.start = FLAGS_start;
  if (FLAGS_frames >= 0) request.num_frames = FLAGS_frames;
  request.quiet = FLAGS_quiet;
  request.command_line = command_line;
  request.version = RADIVE_VERSION;
  request.stop = &stop;
  std::string scores;
  const radive::RunStatus status =
      radive::RunSequence(*config, request, source.get(), &error, &scores);
  std::fputs(scores.c_str(), stdout);
  switch (status) {
    case radive::RunStatus::kDone:
      return radive::EndApp(ExitStatus::kSuccess);
    case radive::RunStatus::kInterrupted:
      std::fprintf(stderr, "radive_odometry: interrupted; the results so far are whole\n");
      return radive::EndApp(ExitStatus::kInterrupted);
    case radive::RunStatus::kNoResult:
      Fail(error);
      return radive::EndApp(ExitStatus::kNoResult);
    case radive::RunStatus::kFailed:
      return Fail(error);
  }
  return radive::EndApp(ExitStatus::kFailure);
}
