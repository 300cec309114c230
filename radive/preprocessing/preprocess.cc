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
                                        DropCounts* counts) {
  DropCounts ignored;
  if (counts == nullptr) counts = &ignored;
  std::vector<RadarReturn> kept;
  kept.reserve(scan.returns.size());
  const FieldOfView field_of_view(options);
  const bool needs_correction = NeedsCorrection(sensor);
  for (const RadarReturn& entry : scan.returns) {
    if (!entry.position.allFinite()) {
      ++counts->not_finite;
      continue;
    }
    if (scan.has_doppler && !std::isfinite(entry.doppler)) {
      ++counts->no_doppler;
      continue;
    }
    const Eigen::Vector3d position =
        needs_correction ? CorrectPosition(entry.position, sensor) : entry.position;
    if (!field_of_view.Contains(position)) {
      ++(field_of_view.IsInRange(position) ? counts->out_of_view : counts->out_of_range);
      continue;
    }
    kept.push_back({position, entry.doppler, entry.power});
  }
  return kept;
}

std::vector<RadarReturn> Preprocess(const RadarScan& scan,
                                    const SensorOptions& sensor,
                                    const PreprocessingOptions& options,
                                    DropCounts* counts) {
  const std::vector<RadarReturn> gated = CorrectAndGate(scan, sensor, options, counts);
  std::vector<RadarReturn> kept = FilterAzimuthBins(gated, options);
  if (counts != nullptr) counts->behind_nearest += static_cast<int>(gated.size() - kept.size());
  return kept;
}

}  // namespace radive
