// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/bytes/hdf5_table.h"
#include "radive/io/datasets/radarscenes_table.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_source.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// The file with the radar data of a RadarScenes sequence as published: `path` itself, if it begins
// as one, or radar_data.h5 in it or in that folder below it. Nothing when it is not there.
std::optional<std::filesystem::path> FindRadarScenesHdf5(const std::filesystem::path& path,
                                                         const std::string& folder = "");

// One of the radars in radar_data.h5: the data set radar_data has a row for each detection, ordered
// by time; the rows with the same timestamp [us] and sensor_id are a scan. Of its columns range_sc
// [m], azimuth_sc [rad, positive to the left], vr (range rate [m/s]) and rcs [dBsm] are read. Scans
// are in the radar's own frame and planar. When it is opened the stamps are read, later the
// detections scan by scan.
class RadarScenesHdf5Source : public ScanSource {
 public:
  // `options` must be valid; input.radar says which. Null, with file and expectation in `error`,
  // when the file cannot be read or has no scans of that radar.
  static std::unique_ptr<RadarScenesHdf5Source> Open(const std::filesystem::path& file,
                                                     const InputOptions& options,
                                                     std::string* error);

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override { return static_cast<int>(scans_.size()); }
  SourceFacts Facts() const override;

 private:
  RadarScenesHdf5Source(std::unique_ptr<Hdf5Table> table,
                        std::filesystem::path file,
                        int radar,
                        const InputOptions& options);
  bool FindScans(std::vector<int>* radars, std::string* error);
  void CompareWithOdometry();

  const std::unique_ptr<Hdf5Table> table_;
  const std::filesystem::path file_;
  const int radar_;
  PointConverter converter_;
  PointTable rows_;
  std::vector<RadarScenesScan> scans_;
  std::size_t next_ = 0;
};

// The radars that have detections in the file, by number. Nothing, with the reason in `error`, when
// it cannot be read.
std::optional<std::vector<int>> RadarsOfRadarScenesHdf5(const std::filesystem::path& file,
                                                        std::string* error);

// The data set odometry: timestamp [us], x_seq, y_seq [m] and yaw_seq [rad], poses of the car
// (origin at the rear axle).
std::optional<RecordedTrajectory> ReadRadarScenesOdometry(const std::filesystem::path& file,
                                                          std::string* error);

}  // namespace radive
