// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>

#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/registration/registration.h"
#include "radive/registration/scan_matcher.h"

namespace radive {

// The methods of the ICP family: each scan point and its nearest neighbour in the submap, found
// anew after every step. Points are the means of the Gaussians: single returns, or the returns of a
// voxel. The loss is that of NDT, saturating at standard deviations of registration.icp_sigma.
//
//   icp          PointToPointFactor
//   plane_icp    PointToPlaneFactor with the normal of the nearest submap points
//   gicp         GicpFactor: the covariances are flat discs along the surface of the nearest
//                points, in the submap and in the scan
//   doppler_icp  as plane_icp, and a DopplerMotionFactor for each return
//
// `input` must outlive it.
std::unique_ptr<ScanMatcher> MakeIcpMatcher(const RegistrationInput& input,
                                            const Eigen::Vector3d& origin,
                                            const PairOptions& pair_options,
                                            const RegistrationOptions& options);

}  // namespace radive
