// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/doppler_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr std::size_t kMostReturns = 250;
constexpr double kUsualSpeed = 20.0;  // three quarters of the range rates are usually below [m/s]

// Every scan by itself, and only those whose returns clearly agree.
EgoVelocityOptions FitOptions() {
  EgoVelocityOptions options;
  options.fit_gate = 0.5;
  options.keep_gate = 0.5;
  options.temporal_gate = 0.0;
  options.min_inlier_share = 0.35;
  options.min_inliers = 8;
  options.vertical_ridge = 0.0;  // which way is up in the radar is not known here
  return options;
}

bool IsUsable(const RadarReturn& ret) {
  return ret.position.allFinite() && std::isfinite(ret.doppler);
}

// kMostReturns of the usable ones at most, evenly from first to last.
std::vector<RadarReturn> Some(const std::vector<RadarReturn>& returns, std::size_t num_usable) {
  const std::size_t count = std::min(num_usable, kMostReturns);
  std::vector<RadarReturn> some;
  some.reserve(count);
  std::size_t number = 0;  // of the next usable one
  for (const RadarReturn& ret : returns) {
    if (some.size() == count) break;
    if (IsUsable(ret) && number++ == some.size() * num_usable / count) some.push_back(ret);
  }
  return some;
}

// By which the Doppler is divided so that it has the size of cars' speeds.
double Unit(const std::vector<RadarReturn>& returns) {
  std::vector<double> sizes;
  for (const RadarReturn& ret : returns) sizes.push_back(std::abs(ret.doppler));
  const auto third_quarter = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 3 / 4);
  std::nth_element(sizes.begin(), third_quarter, sizes.end());
  return std::max(1.0, *third_quarter / kUsualSpeed);
}

EgoVelocity Fit(const std::vector<RadarReturn>& returns,
                const RadarScan& scan,
                const SensorOptions& sensor) {
  EgoVelocityEstimator estimator(FitOptions(), sensor);
  return estimator.Estimate(returns, scan.is_planar, scan.stamp_ns);
}

}  // namespace

DopplerFit FitDoppler(const RadarScan& scan, const SensorOptions& sensor) {
  DopplerFit result;
  const auto num_usable =
      static_cast<std::size_t>(std::count_if(scan.returns.begin(), scan.returns.end(), IsUsable));
  if (num_usable == 0) return result;
  result.share_with_doppler =
      static_cast<double>(num_usable) / static_cast<double>(scan.returns.size());
  std::vector<RadarReturn> returns = Some(scan.returns, num_usable);
  result.num_returns = static_cast<int>(returns.size());
  SensorOptions plain;
  if (sensor.doppler_span > 0.0) {
    plain.doppler_span = sensor.doppler_span;
    plain.mount_yaw = sensor.mount_yaw;
  }
  const double unit = sensor.doppler_span > 0.0 ? 1.0 : Unit(returns);
  for (RadarReturn& ret : returns) ret.doppler /= unit;
  const EgoVelocity plus = Fit(returns, scan, plain);
  result.num_inliers = plus.num_inliers;
  if (plus.valid) {
    result.v_plus = unit * plus.v_radar;
    result.v_minus = -*result.v_plus;
  }
  if (sensor.doppler_span > 0.0) {
    std::vector<RadarReturn> turned = returns;
    for (RadarReturn& ret : turned) ret.doppler = -ret.doppler;
    const EgoVelocity minus = Fit(turned, scan, plain);
    result.v_minus.reset();
    if (minus.valid) result.v_minus = minus.v_radar;
  }
  // All returns of a radar that stands agree, however they are dealt.
  result.num_by_chance = result.num_returns;
  if (plus.valid && plus.v_radar.norm() < kStandingSpeed) return result;
  Random random(1);
  for (std::size_t i = returns.size() - 1; i > 0; --i) {
    std::swap(returns[i].doppler, returns[random.Index(i + 1)].doppler);
  }
  result.num_by_chance = Fit(returns, scan, plain).num_inliers;
  return result;
}

}  // namespace radive
