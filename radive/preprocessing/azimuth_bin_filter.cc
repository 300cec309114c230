// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/azimuth_bin_filter.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "radive/geometry/spherical.h"
#include "radive/util/angle_units.h"
#include "radive/util/cell_key.h"

namespace radive {
namespace {

// Elevations of one ray differ by the rounding of its coordinates, which scans store in single
// precision: a few times 6e-8 rad.
constexpr double kSameElevation = 1e-6;  // [rad]

// Index of the bin of `value` in [low, low + extent]; the upper edge belongs to the last bin.
std::int64_t BinIndex(double value, double low, double extent, double width) {
  const auto num_bins = static_cast<std::int64_t>(std::ceil(extent / width));
  const auto index = static_cast<std::int64_t>(std::floor((value - low) / width));
  return std::clamp<std::int64_t>(index, 0, num_bins - 1);
}

std::int64_t AzimuthBinOf(const Spherical& s, const PreprocessingOptions& options) {
  return BinIndex(s.azimuth, -kPi, 2.0 * kPi, options.azimuth_bin_width);
}

// A return in the order of its direction.
struct Ray {
  std::int64_t azimuth_bin;
  double elevation;
  double range;
  std::size_t index;
};

// Marks the nearest return of each azimuth bin and elevation, the first of those as near.
std::vector<bool> NearestOfEqualElevation(const std::vector<RadarReturn>& returns,
                                          const PreprocessingOptions& options) {
  std::vector<Ray> rays;
  rays.reserve(returns.size());
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const Spherical s = ToSpherical(returns[i].position);
    rays.push_back({AzimuthBinOf(s, options), s.elevation, s.range, i});
  }
  std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
    return std::tie(a.azimuth_bin, a.elevation, a.index) <
           std::tie(b.azimuth_bin, b.elevation, b.index);
  });
  std::vector<bool> is_kept(returns.size(), false);
  for (std::size_t begin = 0; begin < rays.size();) {
    std::size_t nearest = begin, end = begin + 1;
    for (; end < rays.size() && rays[end].azimuth_bin == rays[begin].azimuth_bin &&
           rays[end].elevation - rays[end - 1].elevation <= kSameElevation;
         ++end) {
      if (std::tie(rays[end].range, rays[end].index) <
          std::tie(rays[nearest].range, rays[nearest].index)) {
        nearest = end;
      }
    }
    is_kept[rays[nearest].index] = true;
    begin = end;
  }
  return is_kept;
}

// Marks the nearest return of each azimuth and elevation bin, the first of those as near.
std::vector<bool> NearestOfElevationBin(const std::vector<RadarReturn>& returns,
                                        const PreprocessingOptions& options) {
  struct Nearest {
    double range = 0.0;
    std::size_t index = 0;
  };
  tsl::robin_map<std::uint64_t, Nearest, CellKeyHash> nearest;
  nearest.reserve(returns.size());
  std::vector<bool> is_kept(returns.size(), false);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const Spherical s = ToSpherical(returns[i].position);
    const std::uint64_t key =
        CellKey(AzimuthBinOf(s, options),
                BinIndex(s.elevation, -0.5 * kPi, kPi, options.elevation_bin_width),
                std::int64_t{0});
    const auto [entry, is_new] = nearest.try_emplace(key, Nearest{s.range, i});
    if (!is_new) {
      if (s.range >= entry->second.range) continue;
      is_kept[entry->second.index] = false;
      entry.value() = {s.range, i};
    }
    is_kept[i] = true;
  }
  return is_kept;
}

}  // namespace

std::vector<RadarReturn> FilterAzimuthBins(const std::vector<RadarReturn>& returns,
                                           const PreprocessingOptions& options) {
  if (options.azimuth_bin == PreprocessingOptions::AzimuthBin::kOff) return returns;
  const std::vector<bool> is_kept = options.azimuth_bin == PreprocessingOptions::AzimuthBin::kExact
                                        ? NearestOfEqualElevation(returns, options)
                                        : NearestOfElevationBin(returns, options);
  std::vector<RadarReturn> kept;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    if (is_kept[i]) kept.push_back(returns[i]);
  }
  return kept;
}

}  // namespace radive
