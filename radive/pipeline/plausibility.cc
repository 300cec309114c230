// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/plausibility.h"

#include <algorithm>
#include <cmath>

#include "radive/util/number_text.h"
#include "radive/util/seconds.h"

namespace radive {
namespace {

constexpr std::size_t kMostValues = 5000;     // of each kind
constexpr std::size_t kReturnsPerScan = 200;  // of these
constexpr std::size_t kFewestValues = 5;

// Half of the returns of a road radar lie within 20 to 80 m; beyond this its unit is not metres
// [m].
constexpr double kFarthestMedian = 500.0;
// Between a hundred and a thousand times 80 m or 20 m, in the middle of their logarithms [m].
constexpr double kCentimetresEnd = 12500.0;
// Rates of radars with a margin [Hz], and a speed that no car has [m/s].
constexpr double kHighestRate = 200.0;
constexpr double kLowestRate = 0.4;
constexpr double kHighestSpeed = 150.0;

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void Plausibility::AddScan(const RadarScan& scan) {
  const std::size_t step = std::max<std::size_t>(1, scan.returns.size() / kReturnsPerScan);
  for (std::size_t i = 0; i < scan.returns.size() && ranges_.size() < kMostValues; i += step) {
    const double range = scan.returns[i].position.norm();
    if (std::isfinite(range)) ranges_.push_back(range);
  }
  const auto [last, is_first] = last_stamp_ns_.try_emplace(scan.radar, scan.stamp_ns);
  if (!is_first && scan.stamp_ns > last->second && intervals_.size() < kMostValues) {
    intervals_.push_back(Seconds(scan.stamp_ns) - Seconds(last->second));
  }
  last->second = scan.stamp_ns;
}

void Plausibility::AddPose(const OdometryResult& result) {
  if (result.status != OdometryResult::Status::kRegistered) {
    last_pose_.clear();
    return;
  }
  if (!last_pose_.empty() && speeds_.size() < kMostValues) {
    const double dt = Seconds(result.stamp_ns - last_pose_[0].stamp_ns);
    const double distance =
        (result.T_world_body.translation - last_pose_[0].T_world_body.translation).norm();
    if (dt > 0.0) speeds_.push_back(distance / dt);
  }
  last_pose_.assign(1, {result.stamp_ns, result.T_world_body});
}

std::vector<std::string> Plausibility::Warnings() const {
  std::vector<std::string> warnings;
  if (ranges_.size() >= kFewestValues) {
    const double range = Median(ranges_);
    if (range > kFarthestMedian) {
      const bool are_cm = range < kCentimetresEnd;
      warnings.push_back(
          FormatText("half of the returns are farther than %.4g m: are the positions in ", range) +
          (are_cm ? "centimetres" : "millimetres") + "? Metres are expected");
    }
  }
  if (intervals_.size() >= kFewestValues) {
    const double rate = 1.0 / Median(intervals_);
    if (rate > kHighestRate || rate < kLowestRate) {
      warnings.push_back(FormatText("the stamps say %.4g scans per second", rate) +
                         ", which no radar makes: is their unit right?");
    }
  }
  if (speeds_.size() >= kFewestValues) {
    const double speed = Median(speeds_);
    if (speed > kHighestSpeed) {
      warnings.push_back(
          FormatText("the poses move at %.4g m/s", speed) +
          ": are the positions in metres, and is the unit of the stamps (or input.rate) right?");
    }
  }
  return warnings;
}

}  // namespace radive
