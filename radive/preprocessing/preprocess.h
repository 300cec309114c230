// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// What became of the returns of a scan; the parts sum up to num_returns.
struct PreprocessingCounts {
  int num_returns = 0;
  int num_not_finite = 0;       // position not finite
  int num_without_doppler = 0;  // Doppler not finite, in a scan that has Doppler
  int num_out_of_view = 0;
  int num_behind_nearest = 0;  // dropped by the azimuth bins
  int num_kept = 0;
};

// The first part of Preprocess(): drops what is not finite, corrects positions by the sensor's
// calibration, and gates the field of view. In a scan with Doppler a return without is dropped too.
// Call it alone where the velocity is to be fitted to all returns, before the azimuth bins.
// Keeps the order of the returns. `counts` may be null.
std::vector<RadarReturn> CorrectAndGate(const RadarScan& scan,
                                        const SensorOptions& sensor,
                                        const PreprocessingOptions& options,
                                        PreprocessingCounts* counts);

// CorrectAndGate() and then FilterAzimuthBins().
std::vector<RadarReturn> Preprocess(const RadarScan& scan,
                                    const SensorOptions& sensor,
                                    const PreprocessingOptions& options,
                                    PreprocessingCounts* counts);

}  // namespace radive
