// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "radive/simulation/simulation_options.h"

namespace radive {

// Simulates a drive into `folder`, which is created and must be empty when it exists:
//
//   radar/NNNNNN.bin   scan: little-endian float32, five per return: x y z doppler power
//                      [m, m, m, m/s, dB], the layout "xyzdp5"; other places and forms by `format`,
//                      see ScanWriterNames()
//   labels/NNNNNN.bin  one byte per return: ReturnLabel
//   times.txt          line k: stamp of scan k, integer [ns]
//   gt_tum.txt         line k: true pose at scan k, "t x y z qx qy qz qw" [s, m], maps the radar
//                      frame of scan k to that of scan 0
//   scenario.json      what was simulated
//
// All of it appears in one step, see OutputFolder. `progress` is called after each scan with the
// number of scans written and of all scans; it may be empty. On failure returns false and names the
// file or the setting in `error`.
bool WriteSimulation(const std::string& scenario,
                     const SimulationOptions& options,
                     const std::string& format,
                     const std::filesystem::path& folder,
                     const std::function<void(int, int)>& progress,
                     std::string* error);

}  // namespace radive
