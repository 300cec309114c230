// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/result_rows.h"

#include "radive/io/trajectories/trajectory_io.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// A text as one CSV field.
std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "\"";
}

template <typename Matrix>
std::string UpperTriangle(const Matrix& matrix) {
  std::string text;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int col = row; col < matrix.cols(); ++col) text += "," + ShortText(matrix(row, col));
  }
  return text;
}

std::string UpperTriangleNames(const std::string& prefix, const std::string* names, int size) {
  std::string text;
  for (int row = 0; row < size; ++row) {
    for (int col = row; col < size; ++col) {
      text += "," + prefix + "_" + names[row] + "_" + names[col];
    }
  }
  return text;
}

}  // namespace

std::string TumRow(const OdometryResult& result) {
  return TumLine({result.stamp_ns, result.T_world_body}) + "\n";
}

std::string KittiRow(const OdometryResult& result) {
  return KittiLine({result.stamp_ns, result.T_world_body}) + "\n";
}

std::string ScansHeader() {
  const std::string axes[] = {"x", "y", "z"};
  const std::string pose[] = {"rx", "ry", "rz", "tx", "ty", "tz"};
  return "index,stamp_ns,radar,status,reason,keyframe,degenerate,returns,kept,not_finite,no_"
         "doppler,"
         "out_of_range,out_of_view,no_velocity,moving,occluded,behind_nearest,gaussians,pairs,"
         "iterations,cost,ego_valid,ego_reason,ego_inliers,ego_returns,ego_rms,vx,vy,vz" +
         UpperTriangleNames("v_cov", axes, 3) + UpperTriangleNames("pose_cov", pose, 6) + "\n";
}

std::string ScansRow(const OdometryResult& result, int radar) {
  const EgoVelocity& ego = result.ego_velocity;
  std::string row;
  const auto add = [&row](const std::string& field) { row += "," + field; };
  add(std::to_string(result.stamp_ns));
  add(std::to_string(radar));
  add(ToString(result.status));
  add(Quoted(result.reason));
  add(result.is_keyframe ? "1" : "0");
  add(result.degenerate ? "1" : "0");
  for (const int count : {result.num_returns,
                          result.num_kept,
                          result.dropped.not_finite,
                          result.dropped.no_doppler,
                          result.dropped.out_of_range,
                          result.dropped.out_of_view,
                          result.dropped.no_velocity,
                          result.dropped.moving,
                          result.dropped.occluded,
                          result.dropped.behind_nearest,
                          result.num_gaussians,
                          result.num_pairs,
                          result.num_iterations}) {
    add(std::to_string(count));
  }
  add(ShortText(result.cost));
  add(ego.valid ? "1" : "0");
  add(Quoted(ego.reason));
  add(std::to_string(ego.num_inliers));
  add(std::to_string(ego.num_returns));
  add(ShortText(ego.residual_rms));
  for (int axis = 0; axis < 3; ++axis) add(ShortText(ego.v_radar[axis]));
  return std::to_string(result.index) + row + UpperTriangle(ego.covariance) +
         UpperTriangle(result.covariance) + "\n";
}

std::string TimingHeader() {
  return "index,read_ms,preprocessing_ms,ego_velocity_ms,pair_search_ms,registration_ms,submap_ms,"
         "odometry_ms,total_ms\n";
}

std::string TimingRow(const OdometryResult& result, double read_ms) {
  const OdometryResult::Times& times = result.times_ms;
  std::string row = std::to_string(result.index);
  for (const double value : {read_ms,
                             times.preprocessing,
                             times.ego_velocity,
                             times.pair_search,
                             times.registration,
                             times.submap,
                             times.total,
                             read_ms + times.total}) {
    row += FormatText(",%.4f", value);
  }
  return row + "\n";
}

}  // namespace radive
