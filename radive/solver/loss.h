// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/loss_function.h>
#include <glog/logging.h>

#include <cmath>

namespace radive {

// Welsch loss:
//
//   rho(s) = c^2 (1 - exp(-s / c^2))
//
// s  squared norm of the whitened residuals of a block [-]
// c  residual, in standard deviations, from which on the loss saturates [-]
//
// rho(s) = s near zero and c^2 far away. rho'' < 0 everywhere, so Ceres uses it as plain
// iteratively re-weighted least squares: always safe, linearly convergent. With c^2 = 2 and a
// factor of k w it is the NDT score of a pair (design: NdtPairFactor); the factor goes in
// through ceres::ScaledLoss.
class WelschLoss final : public ceres::LossFunction {
 public:
  // `scale` is c, > 0.
  explicit WelschLoss(double scale) : squared_scale_(scale * scale) { CHECK_GT(scale, 0.0); }

  // rho[0..2] = rho(s), rho'(s), rho''(s).
  void Evaluate(double s, double rho[3]) const override {
    const double decay = std::exp(-s / squared_scale_);
    // expm1 keeps the digits of small s that 1 - exp(-s) loses.
    rho[0] = -squared_scale_ * std::expm1(-s / squared_scale_);
    rho[1] = decay;
    rho[2] = -decay / squared_scale_;
  }

 private:
  const double squared_scale_;
};

}  // namespace radive
