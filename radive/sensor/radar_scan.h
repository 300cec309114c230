// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace radive {

// One detection of a radar.
struct RadarReturn {
  // Position in the radar frame, FLU: x forward, y left, z up [m].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();

  // Range rate, positive when the return moves away [m/s]; a static return has -d . v_radar with
  // d = position / |position|. NaN when the sensor stored none.
  double doppler = std::numeric_limits<double>::quiet_NaN();

  // Power, SNR or radar cross section, as the source has it [dB or dBsm]; NaN when unknown.
  double power = std::numeric_limits<double>::quiet_NaN();
};

// All returns of one radar measurement cycle.
struct RadarScan {
  std::int64_t stamp_ns = 0;  // [ns], any epoch
  int radar = 0;              // which radar of the vehicle, as the dataset numbers it
  bool has_doppler = false;   // false: the dataset stores no Doppler at all
  bool is_planar = false;     // true: the sensor measures no elevation, z is 0 in all returns
  std::vector<RadarReturn> returns;
  std::string place;  // where it was read: "FOLDER/000012.bin" or "FILE.csv:13", for messages
};

}  // namespace radive
