// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/ndt/ndt_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// Every return as its own Gaussian, in the radar frame: the sensor's noise ellipsoid at that range
// and direction plus epsilon I. `weights` [-], one a return.
// `is_planar`: the sensor measures no elevation.
std::vector<Gaussian3> GaussiansOfReturns(const std::vector<RadarReturn>& returns,
                                          const std::vector<double>& weights,
                                          const SensorOptions& sensor,
                                          const NdtOptions& options,
                                          bool is_planar = false);

// One Gaussian a voxel (paper, NDT section): mean, covariance of the points over n, plus
// epsilon I, and mean weight. Voxels lie on the grid of the frame that the points are given in, and
// come out in the order in which the points first touched them.
std::vector<Gaussian3> GaussiansOfVoxels(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<double>& weights,
                                         const NdtOptions& options);

}  // namespace radive
