// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/preprocess.h"

#include <cmath>

#include "radive/preprocessing/azimuth_bin_filter.h"
#include "radive/preprocessing/field_of_view_filter.h"
#include "radive/sensor/measurement_correction.h"

namespace radive {

std::vector<RadarReturn> CorrectAndGate(const RadarScan& scan,
                                        const SensorOptions& sensor,
                                        const PreprocessingOptions& options,
                                        PreprocessingCounts* counts) {
  PreprocessingCounts local;
  std::vector<RadarReturn> kept;
  kept.reserve(scan.returns.size());
  const FieldOfView field_of_view(options);
  for (const RadarReturn& measured : scan.returns) {
    RadarReturn entry = measured;
    if (!entry.position.allFinite()) {
      ++local.num_not_finite;
      continue;
    }
    if (scan.has_doppler && !std::isfinite(entry.doppler)) {
      ++local.num_without_doppler;
      continue;
    }
    entry.position = CorrectPosition(entry.position, sensor);
    if (!field_of_view.Contains(entry.position)) {
      ++local.num_out_of_view;
      continue;
    }
    kept.push_back(entry);
  }
  local.num_returns = static_cast<int>(scan.returns.size());
  local.num_kept = static_cast<int>(kept.size());
  if (counts != nullptr) *counts = local;
  return kept;
}

std::vector<RadarReturn> Preprocess(const RadarScan& scan,
                                    const SensorOptions& sensor,
                                    const PreprocessingOptions& options,
                                    PreprocessingCounts* counts) {
  std::vector<RadarReturn> kept =
      FilterAzimuthBins(CorrectAndGate(scan, sensor, options, counts), options);
  if (counts != nullptr) {
    counts->num_behind_nearest = counts->num_kept - static_cast<int>(kept.size());
    counts->num_kept = static_cast<int>(kept.size());
  }
  return kept;
}

}  // namespace radive
