// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "radive/odometry/odometry_result.h"
#include "radive/pipeline/output_file.h"
#include "radive/util/output_folder.h"

namespace radive {

// What a run knows of a scan besides the odometry's result.
struct ScanInfo {
  int radar = 0;         // which radar of the vehicle measured it
  double read_ms = 0.0;  // time spent in the source [ms]
};

// The results folder of a run. Rows are streamed into hidden files, .NAME.partial, so memory does
// not grow with the drive and a killed run leaves its poses; all files get their names at once, in
// Publish(). Until then earlier results stay as they are.
//
//   trajectory_tum.txt    "t x y z qx qy qz qw" of T_world_body, a line for each input scan
//   trajectory_kitti.txt  rows of [R | t], a line for each input scan
//   scans.csv             status, ego velocity, registration and covariances of each scan
//   timing.csv            milliseconds of each stage and scan (the only file that varies, with
//                         run.json, between two runs of the same command)
//   map.ply, neural_points.ply, mesh.ply, sdf_slice.ply   see map_files.h
//   scores.json, config.yaml, run.json                    see WriteText()
class ResultWriter {
 public:
  // Makes the folder, locks it and opens the streamed files. A folder that another program writes
  // into, or that holds anything but earlier results, is left alone, with an error.
  bool Open(const std::filesystem::path& folder, std::string* error);

  // False when something could not be written (a full disk): `error` names the file.
  bool AddScan(const ScanInfo& info, const OdometryResult& result, std::string* error);

  // After the last scan: the streamed files are complete, still under their partial names.
  bool EndScans(std::string* error);

  // A file in one go, such as run.json.
  bool WriteText(const std::string& name, const std::string& text, std::string* error);

  // Where a file is until Publish().
  std::filesystem::path Partial(const std::string& name) const;

  // Replaces earlier results by what was written, in one step. False when that cannot be; the
  // earlier results are whole then.
  bool Publish(std::string* error);

 private:
  std::array<std::pair<const char*, OutputFile*>, 4> Streams();

  std::filesystem::path folder_;
  OutputFolder output_;
  std::vector<std::string> names_;  // of all files
  OutputFile tum_;
  OutputFile kitti_;
  OutputFile scans_;
  OutputFile timing_;
};

// The map of a drive: one point for each cube of edge `resolution` [m] that holds any, the first;
// all points when it is 0. Grows with the area that was driven through, not with the drive.
class MapThinner {
 public:
  explicit MapThinner(double resolution) : resolution_(resolution) {}

  void Add(const std::vector<Eigen::Vector3d>& points);
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  const double resolution_;
  std::unordered_set<std::uint64_t> taken_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace radive
