// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/scan_source.h"

namespace radive::testing {

// Velocity of a radar that mostly moves ahead, in its frame [m/s].
inline const Eigen::Vector3d kForward(8.0, 0.5, -0.2);

// A scan of static returns all around the front of a radar that moves with `v_radar` [m/s].
inline RadarScan StaticScan(std::int64_t stamp_ns,
                            const Eigen::Vector3d& v_radar,
                            double doppler_sign) {
  RadarScan scan;
  scan.stamp_ns = stamp_ns;
  scan.has_doppler = true;
  for (int i = 0; i < 40; ++i) {
    const double azimuth = -1.0 + 0.05 * i;
    const double elevation = 0.1 * std::sin(1.7 * i);
    const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                    std::cos(elevation) * std::sin(azimuth),
                                    std::sin(elevation));
    RadarReturn ret;
    ret.position = (10.0 + i) * direction;
    ret.doppler = -doppler_sign * direction.dot(v_radar);
    scan.returns.push_back(ret);
  }
  return scan;
}

// Hands out `scans`, then ends, or fails with `error_at_end` if that is not empty.
class FakeScanSource : public ScanSource {
 public:
  explicit FakeScanSource(std::vector<RadarScan> scans, std::string error_at_end = "")
      : scans_(std::move(scans)), error_at_end_(std::move(error_at_end)) {}

  Status Next(RadarScan* scan) override {
    if (before_next) before_next(num_read_);
    if (num_read_ < scans_.size()) {
      *scan = scans_[num_read_++];
      return Status::kScan;
    }
    error_ = error_at_end_;
    return error_at_end_.empty() ? Status::kEnd : Status::kError;
  }
  std::string Description() const override { return "made-up scans"; }
  std::optional<int> NumScans() const override { return static_cast<int>(scans_.size()); }

  void Warn(const std::string& warning) { warnings_.push_back(warning); }
  std::size_t num_read() const { return num_read_; }

  std::function<void(std::size_t)> before_next;  // gets the number of scans handed out

 private:
  const std::vector<RadarScan> scans_;
  const std::string error_at_end_;
  std::size_t num_read_ = 0;
};

// What a radar at `t_world_radar` that moves with `v_radar` [m/s] and never turns sees of a lasting
// world: posts a few metres apart, those within 60 m, the nearest first.
inline RadarScan ScanOfPosts(std::int64_t stamp_ns,
                             const Eigen::Vector3d& t_world_radar,
                             const Eigen::Vector3d& v_radar,
                             double doppler_sign) {
  RadarScan scan;
  scan.stamp_ns = stamp_ns;
  scan.has_doppler = true;
  const auto nearest = [](double metres) { return static_cast<int>(std::floor(metres / 8.0)); };
  const int column = nearest(t_world_radar.x()), row = nearest(t_world_radar.y());
  for (int x = column - 7; x <= column + 7; ++x) {
    for (int y = row - 7; y <= row + 7; ++y) {
      const double shift = 3.0 * std::sin(12.9 * x + 78.2 * y + 0.4);
      const Eigen::Vector3d post(8.0 * x + shift,
                                 8.0 * y + 3.0 * std::sin(39.3 * x + 11.1 * y + 0.9),
                                 std::sin(5.1 * x + 2.7 * y + 1.3));
      RadarReturn ret;
      ret.position = post - t_world_radar;
      const double range = ret.position.norm();
      if (range < 2.0 || range > 60.0) continue;
      ret.doppler = -doppler_sign * ret.position.dot(v_radar) / range;
      scan.returns.push_back(ret);
    }
  }
  std::sort(
      scan.returns.begin(), scan.returns.end(), [](const RadarReturn& a, const RadarReturn& b) {
        return a.position.norm() < b.position.norm();
      });
  return scan;
}

// `count` scans at 10 Hz of a radar that drives straight on through the posts.
inline std::vector<RadarScan> StaticScans(int count,
                                          const Eigen::Vector3d& v_radar,
                                          double doppler_sign) {
  std::vector<RadarScan> scans;
  for (int i = 0; i < count; ++i) {
    scans.push_back(ScanOfPosts(100'000'000LL * i, 0.1 * i * v_radar, v_radar, doppler_sign));
  }
  return scans;
}

}  // namespace radive::testing
