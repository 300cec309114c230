// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <cmath>

namespace radive {

// Doppler factor: one radar return constrains the radar's own velocity.
//
//   r(v) = wrap(v_doppler + d^T v) / sigma
//
// d          unit direction from the radar to the return, in the radar frame [-]
// v          velocity of the radar w.r.t. the world, in the radar frame      [m/s]
// v_doppler  measured range rate, positive when the return moves away        [m/s]
// sigma      standard deviation of v_doppler                                 [m/s]
// wrap       x - span round(x / span), for a v_doppler that is known but for multiples of span
//            [m/s]: the difference to the nearest of them. Nothing where the span is 0.
//
// The return is assumed to be static; moving returns are left to the gate of the caller. A planar
// sensor has d_z = 0, so its returns say nothing of v_z. What is known of v_z has the form of this
// factor as well: a vehicle that does not climb is d = (0, 0, 1), v_doppler = 0.
// Parameter blocks: v (3). Residuals: 1, unit-free.
// Source: Kellner et al. 2013, extended to 3D; RaDiVe, ego-velocity section.
class DopplerFactor {
 public:
  DopplerFactor(const Eigen::Vector3d& direction_radar,
                double v_doppler,
                double sigma,
                double span = 0.0)
      : direction_radar_(direction_radar),
        v_doppler_(v_doppler),
        inv_sigma_(1.0 / sigma),
        span_(span) {}

  template <typename T>
  bool operator()(const T* const v_radar_ptr, T* residual) const {
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> v_radar(v_radar_ptr);
    T difference = v_doppler_ + direction_radar_.cast<T>().dot(v_radar);
    if (span_ > 0.0) {
      using std::floor;
      difference -= span_ * floor(difference / span_ + 0.5);
    }
    residual[0] = inv_sigma_ * difference;
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& direction_radar,
                                     double v_doppler,
                                     double sigma,
                                     double span = 0.0) {
    return new ceres::AutoDiffCostFunction<DopplerFactor, 1 /* residuals */, 3 /* v_radar */>(
        new DopplerFactor(direction_radar, v_doppler, sigma, span));
  }

 private:
  const Eigen::Vector3d direction_radar_;
  const double v_doppler_;
  const double inv_sigma_;
  const double span_;
};

}  // namespace radive
