// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/ndt/ndt_options.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Which Gaussians suit a sensor, by the static returns of one of its scans: those of voxels when
// the scan has at least 1,000 returns, two or more for each voxel of options.voxel_size that holds
// any, or at least 4,000 returns however they are spread (each return for itself costs a second a
// scan beyond); those of points otherwise. Radars for cars give 100 to 800 returns a scan, imaging
// radars and lidars 2,000 to 100,000. `reason`: what was seen, for the log.
NdtOptions::Representation ChooseRepresentation(const std::vector<RadarReturn>& returns,
                                                const NdtOptions& options,
                                                std::string* reason);

}  // namespace radive
