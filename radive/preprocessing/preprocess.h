// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/preprocessing/drop_counts.h"
#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// The first part of Preprocess(): drops what is not finite, corrects positions by the sensor's
// calibration, and gates the field of view. In a scan with Doppler a return without is dropped too.
// Call it alone where the velocity is to be fitted to all returns, before the azimuth bins.
// Keeps the order of the returns; what is dropped is added to `counts`, which
// may be null.
std::vector<RadarReturn> CorrectAndGate(const RadarScan& scan,
                                        const SensorOptions& sensor,
                                        const PreprocessingOptions& options,
                                        DropCounts* counts);

// CorrectAndGate() and then FilterAzimuthBins().
std::vector<RadarReturn> Preprocess(const RadarScan& scan,
                                    const SensorOptions& sensor,
                                    const PreprocessingOptions& options,
                                    DropCounts* counts);

}  // namespace radive
