// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/field_of_view_filter.h"

#include <cmath>

#include "radive/util/angle_units.h"

namespace radive {

FieldOfView::FieldOfView(const PreprocessingOptions& options)
    : min_range_(options.min_range),
      max_range_(options.max_range),
      right_(std::cos(options.min_azimuth), std::sin(options.min_azimuth)),
      left_(std::cos(options.max_azimuth), std::sin(options.max_azimuth)),
      is_round_(options.min_azimuth <= -kPi && options.max_azimuth >= kPi),
      is_wide_(options.max_azimuth - options.min_azimuth > kPi),
      min_sine_(options.min_elevation <= -0.5 * kPi ? -2.0 : std::sin(options.min_elevation)),
      max_sine_(options.max_elevation >= 0.5 * kPi ? 2.0 : std::sin(options.max_elevation)) {}

bool FieldOfView::IsInRange(const Eigen::Vector3d& p_radar) const {
  const double range = p_radar.norm();
  return range >= min_range_ && range <= max_range_;
}

bool FieldOfView::Contains(const Eigen::Vector3d& p_radar) const {
  const double range = p_radar.norm();
  if (!std::isfinite(range) || !(range >= min_range_ && range <= max_range_)) return false;
  if (!(p_radar.z() >= range * min_sine_ && p_radar.z() <= range * max_sine_)) return false;
  if (is_round_) return true;
  // What lies straight above or below has the azimuth 0.
  const bool is_vertical = p_radar.x() == 0.0 && p_radar.y() == 0.0;
  const double x = is_vertical ? 1.0 : p_radar.x(), y = p_radar.y();
  const double beyond_right = right_.x() * y - right_.y() * x;  // sines of angles to the left
  const double before_left = left_.y() * x - left_.x() * y;
  return is_wide_ ? beyond_right >= 0.0 || before_left >= 0.0
                  : beyond_right >= 0.0 && before_left >= 0.0;
}

std::vector<RadarReturn> GateFieldOfView(const std::vector<RadarReturn>& returns,
                                         const PreprocessingOptions& options) {
  std::vector<RadarReturn> kept;
  kept.reserve(returns.size());
  const FieldOfView field_of_view(options);
  for (const RadarReturn& entry : returns) {
    if (field_of_view.Contains(entry.position)) kept.push_back(entry);
  }
  return kept;
}

}  // namespace radive
