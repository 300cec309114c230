// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/azimuth_bin_filter.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "radive/geometry/spherical.h"
#include "radive/util/angle_units.h"

namespace radive {
namespace {

struct BinKey {
  std::int64_t azimuth = 0;    // index of the bin
  std::int64_t elevation = 0;  // index of the bin, or the bits of the elevation itself
  bool operator==(const BinKey& other) const {
    return azimuth == other.azimuth && elevation == other.elevation;
  }
};

struct BinHash {
  std::size_t operator()(const BinKey& key) const {
    std::uint64_t h = static_cast<std::uint64_t>(key.elevation) * 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 32)) + static_cast<std::uint64_t>(key.azimuth);
    h *= 0xBF58476D1CE4E5B9ull;
    return static_cast<std::size_t>(h ^ (h >> 31));
  }
};

// Index of the bin of `value` in [low, low + extent]; the upper edge belongs to the last bin.
std::int64_t BinIndex(double value, double low, double extent, double width) {
  const auto num_bins = static_cast<std::int64_t>(std::ceil(extent / width));
  const auto index = static_cast<std::int64_t>(std::floor((value - low) / width));
  return std::clamp<std::int64_t>(index, 0, num_bins - 1);
}

BinKey KeyOf(const Spherical& s, const PreprocessingOptions& options) {
  BinKey key;
  key.azimuth = BinIndex(s.azimuth, -kPi, 2.0 * kPi, options.azimuth_bin_width);
  if (options.azimuth_bin == PreprocessingOptions::AzimuthBin::kQuantised) {
    key.elevation = BinIndex(s.elevation, -0.5 * kPi, kPi, options.elevation_bin_width);
  } else {
    const double elevation = s.elevation + 0.0;  // -0 becomes 0, which compares equal
    static_assert(sizeof(elevation) == sizeof(key.elevation));
    std::memcpy(&key.elevation, &elevation, sizeof(elevation));
  }
  return key;
}

}  // namespace

std::vector<RadarReturn> FilterAzimuthBins(const std::vector<RadarReturn>& returns,
                                           const PreprocessingOptions& options) {
  if (options.azimuth_bin == PreprocessingOptions::AzimuthBin::kOff) return returns;
  struct Nearest {
    double range = 0.0;
    std::size_t index = 0;
  };
  tsl::robin_map<BinKey, Nearest, BinHash> nearest;
  nearest.reserve(returns.size());
  std::vector<char> is_kept(returns.size(), 0);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const Spherical s = ToSpherical(returns[i].position);
    const auto [entry, is_new] = nearest.try_emplace(KeyOf(s, options), Nearest{s.range, i});
    if (!is_new) {
      if (s.range >= entry->second.range) continue;
      is_kept[entry->second.index] = 0;
      entry.value() = {s.range, i};
    }
    is_kept[i] = 1;
  }
  std::vector<RadarReturn> kept;
  kept.reserve(nearest.size());
  for (std::size_t i = 0; i < returns.size(); ++i) {
    if (is_kept[i]) kept.push_back(returns[i]);
  }
  return kept;
}

}  // namespace radive
