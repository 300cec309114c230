// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "radive/odometry/odometry_result.h"

namespace radive {

// Rows of the result files, each with its line end; equal results give equal bytes.

// "t x y z qx qy qz qw": seconds and metres, 9 decimals. The stamp is exact.
std::string TumRow(const OdometryResult& result);

// The top three rows of T_world_radar as a matrix, 12 numbers, 9 decimals.
std::string KittiRow(const OdometryResult& result);

// scans.csv. Units: stamp_ns [ns], v [m/s] in the radar frame and its covariance [m^2/s^2], pose
// covariance (upper triangle, rows; order rotation, translation; world frame) [rad^2, rad m, m^2].
std::string ScansHeader();
std::string ScansRow(const OdometryResult& result, int radar);

// timing.csv, all in milliseconds. total = read + odometry.
std::string TimingHeader();
std::string TimingRow(const OdometryResult& result, double read_ms);

}  // namespace radive
