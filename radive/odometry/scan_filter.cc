// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/scan_filter.h"

#include <cmath>

#include "radive/ego_velocity/velocity_discrepancy.h"
#include "radive/ndt/gaussian_builder.h"
#include "radive/preprocessing/azimuth_bin_filter.h"
#include "radive/preprocessing/occlusion_counts.h"
#include "radive/preprocessing/preprocess.h"
#include "radive/sensor/doppler_wrap.h"
#include "radive/util/stopwatch.h"

namespace radive {

std::vector<Gaussian3> GaussiansOfScan(const FilteredScan& scan, const OdometryOptions& options) {
  if (!options.ndt.IsVoxel()) {
    return GaussiansOfReturns(
        scan.returns, scan.weights, options.sensor, options.ndt, scan.is_planar);
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(scan.returns.size());
  for (const RadarReturn& radar_return : scan.returns) points.push_back(radar_return.position);
  return GaussiansOfVoxels(points, scan.weights, options.ndt);
}

namespace {

// Doppler that wraps becomes what it is at a velocity: what comes behind need not know of it.
void Unwrap(const Eigen::Vector3d& v_radar, double span, std::vector<RadarReturn>* returns) {
  if (span == 0.0) return;
  for (RadarReturn& entry : *returns) {
    const double expected = -entry.position.normalized().dot(v_radar);
    entry.doppler = expected + WrapDoppler(entry.doppler - expected, span);
  }
}

}  // namespace

std::vector<RadarReturn> ScanFilter::StaticReturns(const std::vector<RadarReturn>& returns,
                                                   const Eigen::Vector3d& v_radar,
                                                   DropCounts* dropped) const {
  const double noise_ratio = options_.ego_velocity.sigma_angle / options_.sensor.sigma_doppler;
  const std::vector<bool> keep = KeepMask(
      returns, v_radar, options_.ego_velocity.keep_gate, noise_ratio, options_.sensor.doppler_span);
  std::vector<RadarReturn> kept;
  kept.reserve(returns.size());
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) kept.push_back(returns[i]);
  }
  dropped->moving += static_cast<int>(returns.size() - kept.size());
  if (!options_.occlusion.enabled) return kept;

  std::vector<double> azimuths, ranges;
  for (const RadarReturn& radar_return : kept) {
    azimuths.push_back(std::atan2(radar_return.position.y(), radar_return.position.x()));
    ranges.push_back(radar_return.position.norm());
  }
  const std::vector<int> counts =
      OcclusionCounts(azimuths, ranges, std::vector<bool>(kept.size(), true), options_.occlusion);
  std::vector<RadarReturn> visible;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (counts[i] <= options_.occlusion.max_count) visible.push_back(kept[i]);
  }
  dropped->occluded += static_cast<int>(kept.size() - visible.size());
  return visible;
}

FilteredScan ScanFilter::Filter(const RadarScan& scan, OdometryResult* result) {
  Stopwatch stopwatch;
  DropCounts& dropped = result->dropped;
  FilteredScan filtered;
  filtered.is_planar = scan.is_planar;
  const bool has_bins_first = options_.preprocessing.azimuth_bin_order ==
                              PreprocessingOptions::AzimuthBinOrder::kBeforeVelocity;
  filtered.returns = has_bins_first
                         ? Preprocess(scan, options_.sensor, options_.preprocessing, &dropped)
                         : CorrectAndGate(scan, options_.sensor, options_.preprocessing, &dropped);
  result->times_ms.preprocessing = stopwatch.Lap();

  const bool use_doppler = scan.has_doppler && options_.ego_velocity.enabled;
  if (use_doppler) {
    result->ego_velocity = ego_velocity_.Estimate(filtered.returns, scan.is_planar, scan.stamp_ns);
    // Without a velocity nothing tells static returns from moving ones. But where the Doppler
    // wraps, the first scans may leave it open for long: they count as scans without Doppler.
    if (HasVelocity(result->ego_velocity)) {
      filtered.returns = StaticReturns(filtered.returns, result->ego_velocity.v_radar, &dropped);
      Unwrap(result->ego_velocity.v_radar, options_.sensor.doppler_span, &filtered.returns);
    } else if (options_.sensor.doppler_span == 0.0) {
      dropped.no_velocity += static_cast<int>(filtered.returns.size());
      filtered.returns.clear();
    }
  }
  result->times_ms.ego_velocity = stopwatch.Lap();
  if (!has_bins_first) {
    const std::size_t num_before = filtered.returns.size();
    filtered.returns = FilterAzimuthBins(filtered.returns, options_.preprocessing);
    dropped.behind_nearest += static_cast<int>(num_before - filtered.returns.size());
  }
  filtered.weights =
      use_doppler && HasVelocity(result->ego_velocity) && options_.ego_velocity.weights
          ? DiscrepancyWeights(filtered.returns,
                               result->ego_velocity.v_radar,
                               options_.ego_velocity.discrepancy_scale)
          : std::vector<double>(filtered.returns.size(), 1.0);
  result->num_kept = static_cast<int>(filtered.returns.size());
  result->times_ms.preprocessing += stopwatch.Lap();
  return filtered;
}

}  // namespace radive
