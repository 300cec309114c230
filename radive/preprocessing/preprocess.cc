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
  for (const RadarReturn& measured : scan.returns) {
    RadarReturn entry = measured;
    if (!entry.position.allFinite()) {
      ++counts->not_finite;
      continue;
    }
    if (scan.has_doppler && !std::isfinite(entry.doppler)) {
      ++counts->no_doppler;
      continue;
    }
    entry.position = CorrectPosition(entry.position, sensor);
    if (!field_of_view.Contains(entry.position)) {
      ++(field_of_view.IsInRange(entry.position) ? counts->out_of_view : counts->out_of_range);
      continue;
    }
    kept.push_back(entry);
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
