// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/check_poses.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/io/trajectories/quaternion_order.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr double kFarthest = 1e9;  // [m]
constexpr double kShortestQuaternion = 0.5;
constexpr double kLongestQuaternion = 2.0;
constexpr double kUnitTolerance = 0.01;
constexpr double kNoRotation = 0.05;  // of ||R R^T - I||
constexpr double kPoorRotation = 1e-3;

// Of spikes.
constexpr double kTimesMedian = 20.0;
constexpr double kAcceleration = 30.0;   // [m/s^2] and [rad/s^2]
constexpr double kPositionSpike = 0.5;   // [m]
constexpr double kRotationSpike = 0.35;  // [rad]

double RotationError(const RecordedPose& pose) {
  const Eigen::Matrix3d& R = pose.T_world_body.rotation;
  return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm();
}

std::string Count(std::ptrdiff_t count, const RecordedTrajectory& poses) {
  return std::to_string(count) + " of " + std::to_string(poses.size()) + " poses";
}

// Digits around one comma, with a sign or without and perhaps an exponent.
bool IsDecimalComma(std::string_view word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos || comma == 0 || comma + 1 == word.size()) return false;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string with_point(word);
  with_point[comma] = '.';
  return is_digit(word[comma - 1]) && is_digit(word[comma + 1]) && ParseFinite(with_point);
}

// How far a pose lies off the interpolation of both neighbours, `share` of the way to the one
// after it.
using Deviation = std::function<double(
    const MatrixPose& before, const MatrixPose& pose, const MatrixPose& after, double share)>;

double PositionDeviation(const MatrixPose& before,
                         const MatrixPose& pose,
                         const MatrixPose& after,
                         double share) {
  return (pose.translation - (1.0 - share) * before.translation - share * after.translation).norm();
}

double RotationDeviation(const MatrixPose& before,
                         const MatrixPose& pose,
                         const MatrixPose& after,
                         double share) {
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(before.rotation).slerp(share, Eigen::Quaterniond(after.rotation));
  return q.angularDistance(Eigen::Quaterniond(pose.rotation));
}

struct Spikes {
  std::ptrdiff_t count = 0;
  std::size_t worst = 0;  // position in the trajectory
  double size = 0.0;      // of the worst
};

Spikes FindSpikes(const RecordedTrajectory& poses,
                  bool has_stamps,
                  double least,
                  const Deviation& deviation_of) {
  constexpr std::size_t kFewestPoses = 5;
  Spikes spikes;
  if (poses.size() < kFewestPoses) return spikes;
  std::vector<double> deviations(poses.size(), 0.0);
  std::vector<double> shares(poses.size(), 0.5);
  std::vector<double> accelerations(poses.size(), HUGE_VAL);
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    double share = 0.5;
    double squared_time = 0.0;
    if (has_stamps) {
      const double from_before = poses[i].stamp_s - poses[i - 1].stamp_s;
      const double to_after = poses[i + 1].stamp_s - poses[i].stamp_s;
      if (!(from_before > 0.0 && to_after > 0.0)) continue;
      share = from_before / (from_before + to_after);
      squared_time = from_before * to_after;
    }
    shares[i] = share;
    deviations[i] = deviation_of(
        poses[i - 1].T_world_body, poses[i].T_world_body, poses[i + 1].T_world_body, share);
    if (squared_time > 0.0) accelerations[i] = 2.0 * deviations[i] / squared_time;
  }
  std::vector<double> sorted = deviations;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double bound = std::max(least, kTimesMedian * *middle);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!(deviations[i] > bound && accelerations[i] > kAcceleration)) continue;
    // A pose that is off takes a neighbour with it; one where the speed changes at once does not.
    const bool has_moved_one_before = deviations[i - 1] > 0.5 * shares[i - 1] * deviations[i];
    const bool has_moved_one_after =
        deviations[i + 1] > 0.5 * (1.0 - shares[i + 1]) * deviations[i];
    if (!has_moved_one_before && !has_moved_one_after) continue;
    ++spikes.count;
    if (deviations[i] > spikes.size) {
      spikes.size = deviations[i];
      spikes.worst = i;
    }
  }
  return spikes;
}

void AddSpikes(const Spikes& spikes,
               const RecordedTrajectory& poses,
               const std::string& what,
               const char* unit,
               std::vector<std::string>* doubts) {
  if (spikes.count == 0) return;
  doubts->push_back(what + " of " + Count(spikes.count, poses) +
                    " lie off those of both neighbours, most of all pose " +
                    std::to_string(spikes.worst + 1) + FormatText(" by %.4g ", spikes.size) + unit);
}

}  // namespace

bool CheckPose(const RecordedPose& pose, std::string* problem) {
  const Eigen::Vector3d& p = pose.T_world_body.translation;
  const double norm = pose.quaternion_norm;
  const Eigen::Matrix3d& R = pose.T_world_body.rotation;
  if (!(p.norm() <= kFarthest)) {
    *problem = FormatText("expected a position within 1e9 m, found %g %g %g", p[0], p[1], p[2]);
  } else if (norm != 0.0 && !(norm >= kShortestQuaternion && norm <= kLongestQuaternion)) {
    *problem = FormatText("expected a quaternion of length 1, found one of length %g", norm);
  } else if (!(RotationError(pose) < kNoRotation)) {
    *problem = FormatText("expected a rotation matrix, found one with ||R R^T - I|| = %.3g",
                          RotationError(pose));
  } else if (!(R.determinant() > 0.0)) {
    *problem = FormatText("expected a rotation matrix, found a reflection (determinant %.3g)",
                          R.determinant());
  } else {
    return true;
  }
  return false;
}

bool CheckPoses(const RecordedTrajectory& poses, const std::string& place, std::string* error) {
  std::string problem;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (CheckPose(poses[i], &problem)) continue;
    *error = place + ": pose " + std::to_string(i + 1) + ": " + problem;
    return false;
  }
  return true;
}

bool HasDecimalCommas(std::string_view line, std::string* problem) {
  if (line.find('.') != std::string_view::npos || line.find(',') == std::string_view::npos) {
    return false;
  }
  constexpr std::string_view kBetweenWords = " \t;\r";
  std::size_t num_words = 0;
  std::size_t num_commas = 0;
  std::string_view first;
  for (std::size_t begin = line.find_first_not_of(kBetweenWords);
       begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetweenWords, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    ++num_words;
    if (IsDecimalComma(word) && num_commas++ == 0) first = word;
    begin = line.find_first_not_of(kBetweenWords, end);
  }
  constexpr std::size_t kFewestWords = 3;
  if (num_words < kFewestWords || 2 * num_commas < num_words) return false;
  *problem = "expected numbers with a decimal point, found " + Quoted(first);
  return true;
}

std::vector<std::string> DoubtsAboutPoses(const RecordedTrajectory& poses,
                                          bool has_stamps,
                                          bool has_rotations,
                                          const std::string& place) {
  std::vector<std::string> doubts;
  const auto add = [&](const auto& is_odd, const std::string& what) {
    const std::ptrdiff_t count = std::count_if(poses.begin(), poses.end(), is_odd);
    if (count > 0) doubts.push_back(Count(count, poses) + " have " + what);
  };
  add([](const RecordedPose& pose) { return pose.quaternion_norm == 0.0; },
      "a quaternion of length zero, taken as no rotation");
  add(
      [](const RecordedPose& pose) {
        return pose.quaternion_norm != 0.0 && std::abs(pose.quaternion_norm - 1.0) > kUnitTolerance;
      },
      "a quaternion whose length is more than 1 % off 1");
  add([](const RecordedPose& pose) { return RotationError(pose) > kPoorRotation; },
      "a matrix R that is no rotation but for rounding: ||R R^T - I|| above 1e-3");
  if (has_stamps) {
    std::ptrdiff_t num_back = 0;
    std::size_t first = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      if (poses[i].stamp_ns < poses[i - 1].stamp_ns && num_back++ == 0) first = i;
    }
    if (num_back > 0) {
      doubts.push_back("the stamps of " + Count(num_back, poses) +
                       " go back, the first is that of pose " + std::to_string(first + 1));
    }
  }
  AddSpikes(FindSpikes(poses, has_stamps, kPositionSpike, &PositionDeviation),
            poses,
            "the positions",
            "m",
            &doubts);
  if (has_rotations) {
    AddSpikes(FindSpikes(poses, has_stamps, kRotationSpike, &RotationDeviation),
              poses,
              "the rotations",
              "rad",
              &doubts);
  }
  if (has_rotations && HasScalarFirst(poses)) {
    doubts.push_back(
        "the rotations do not follow the motion, but would if the quaternions were written as "
        "qw qx qy qz: name the columns in the first line");
  }
  for (std::string& doubt : doubts) doubt.insert(0, place + ": ");
  return doubts;
}

}  // namespace radive
