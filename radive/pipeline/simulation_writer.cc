// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/simulation_writer.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <system_error>
#include <variant>

#include "radive/io/bytes/whole_file.h"
#include "radive/io/open/open_scan_writer.h"
#include "radive/simulation/radar_simulator.h"
#include "radive/util/number_text.h"
#include "radive/util/output_folder.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

bool MakeFolder(const fs::path& folder, std::string* error) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) *error = folder.string() + ": cannot be created: " + SystemMessage(code);
  return !code;
}

bool WriteLabels(const fs::path& folder, int k, const GroundTruth& truth, std::string* error) {
  const std::string name = FormatText("%06d.bin", k);
  std::string labels;
  for (const ReturnLabel label : truth.labels) labels.push_back(static_cast<char>(label));
  return WriteFile(folder / "labels" / name, labels, error);
}

std::string TumLine(std::int64_t stamp_ns, const Rigid3& T_first_radar) {
  std::string line = FormatText("%lld.%09lld",
                                static_cast<long long>(stamp_ns / 1000000000),
                                static_cast<long long>(stamp_ns % 1000000000));
  const Eigen::Vector3d& t = T_first_radar.translation;
  const Eigen::Quaterniond& q = T_first_radar.rotation;
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    // Without the sign of a zero that rounding made negative.
    line += FormatText(" %.9f", std::abs(value) < 5e-10 ? 0.0 : value);
  }
  return line + "\n";
}

std::string ScenarioJson(const std::string& scenario,
                         const std::string& format,
                         const RadarSimulator& simulator,
                         int scans,
                         std::int64_t returns,
                         double path_length) {
  SimulationOptions options = simulator.options();
  std::string json = "{\n  \"scenario\": \"" + scenario + "\",\n  \"options\": {\n";
  const std::vector<OptionField> fields = options.Fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool is_word = std::holds_alternative<OptionField::Choice>(fields[i].value);
    const std::string quote = is_word ? "\"" : "";
    json += "    \"" + fields[i].name + "\": " + quote + fields[i].ToString() + quote +
            (i + 1 < fields.size() ? ",\n" : "\n");
  }
  json += "  },\n  \"format\": \"" + format + "\",\n";
  if (format == "raw") json += "  \"layout\": \"xyzdp5\",\n";
  json += FormatText("  \"rate_hz\": %.9g,\n", simulator.sensor().rate);
  json += "  \"num_scans\": " + std::to_string(scans) + ",\n";
  json += "  \"num_returns\": " + std::to_string(returns) + ",\n";
  return json + FormatText("  \"path_length_m\": %.3f,\n", path_length) +
         "  \"labels\": [\"static\", \"ghost\", \"moving\", \"clutter\", "
         "\"duplicate\", \"ambiguous\"]\n}\n";
}

}  // namespace

bool WriteSimulation(const std::string& scenario,
                     const SimulationOptions& options,
                     const std::string& format,
                     const fs::path& output,
                     const std::function<void(int, int)>& progress,
                     std::string* error) {
  // A drive is not written over another one: that may be a recorded one, or have cost hours.
  OutputFolder published;
  if (!options.IsValid(error) || !published.Open(output, nullptr, error) ||
      !published.Stage(error)) {
    return false;
  }
  const fs::path& folder = published.staged();
  if (!MakeFolder(folder / "labels", error)) return false;
  const std::unique_ptr<ScanWriter> writer = OpenScanWriter(format, folder, error);
  if (writer == nullptr) return false;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  Rigid3 T_first_world;
  std::string poses;
  std::int64_t returns = 0, last_stamp_ns = 0;
  int k = 0;
  for (; simulator.Next(&scan, &truth); ++k) {
    if (k == 0) T_first_world = truth.T_world_radar.Inverse();
    if (!writer->Add(scan, error) || !WriteLabels(folder, k, truth, error)) return false;
    poses += TumLine(scan.stamp_ns, T_first_world * truth.T_world_radar);
    last_stamp_ns = scan.stamp_ns;
    returns += static_cast<std::int64_t>(scan.returns.size());
    if (progress) progress(k + 1, options.frames);
  }
  const double path_length = simulator.TravelledAt(last_stamp_ns);
  return writer->Finish(error) && WriteFile(folder / "gt_tum.txt", poses, error) &&
         WriteFile(folder / "scenario.json",
                   ScenarioJson(scenario, format, simulator, k, returns, path_length),
                   error) &&
         published.Publish(error);
}

}  // namespace radive
