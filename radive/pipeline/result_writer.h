// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include "radive/odometry/odometry_result.h"
#include "radive/pipeline/output_file.h"

namespace radive {

// What a run knows of a scan besides the odometry's result.
struct ScanInfo {
  int radar = 0;         // which radar of the vehicle measured it
  double read_ms = 0.0;  // time spent in the source [ms]
};

// The results folder of a run. Rows are streamed, so memory does not grow with the drive; files
// get their names in Finish(), so they appear whole or not at all.
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
  // Creates the folder and opens the streamed files. A folder that holds anything but earlier
  // results is left alone, with an error.
  bool Open(const std::filesystem::path& folder, std::string* error);

  // False when something could not be written (a full disk): `error` names the file.
  bool AddScan(const ScanInfo& info, const OdometryResult& result, std::string* error);

  // A file in one go, such as run.json.
  bool WriteText(const std::string& name, const std::string& text, std::string* error);

  // Removes an earlier run's file that this run does not write.
  void RemoveEarlier(const std::string& name);

  const std::filesystem::path& folder() const { return folder_; }

  // Gives the streamed files their names. Tries all, and reports the first that failed.
  bool Finish(std::string* error);

 private:
  std::filesystem::path folder_;
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
