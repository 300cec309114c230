// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/datasets/radarscenes_table.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// One of the radars of a RadarScenes sequence, in its folder form:
//
//   radarK_scans.csv   a line a scan; read are the columns timestamp_rad (decimal seconds),
//                      first_point and num_points, found by the names in the first line. The other
//                      columns hold ground truth and are not looked at.
//   radarK_points.bin  little-endian float32, rows of 5: range [m], azimuth [rad, positive to the
//                      left], range rate [m/s], radar cross section [dBsm] -> power, and a label,
//                      which is not looked at.
//
// Scans are in the radar's own frame and planar: z is 0. The table is read at once, the points
// scan by scan.
class RadarScenesSource : public ScanSource {
 public:
  // `options` must be valid. Null, with file, line and expectation in `error`, when the files of
  // the radar input.radar are absent, a line cannot be read, or a line asks for rows that the file
  // of points does not have.
  static std::unique_ptr<ScanSource> Open(const std::filesystem::path& path,
                                          const InputOptions& options,
                                          std::string* error);
  ~RadarScenesSource() override;

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;

 private:
  class PointFile;

  explicit RadarScenesSource(const InputOptions& options);
  bool ReadTable(std::string* error);
  bool CheckRows(std::uint64_t num_rows, std::string* error);

  int radar_ = 0;
  std::filesystem::path table_path_;
  std::vector<RadarScenesScan> entries_;
  std::unique_ptr<PointFile> points_;
  std::size_t next_ = 0;
  PointTable rows_;  // of one scan, kept for their memory
  PointConverter converter_;
};

// The radars that have a table in `folder`, by number.
std::vector<int> RadarsOfRadarScenes(const std::filesystem::path& folder);

}  // namespace radive
