// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/loss.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radive {
namespace {

TEST(WelschLoss, HasTheValuesWorkedOutByHand) {
  const WelschLoss loss(/*scale=*/2.0);  // c^2 = 4
  double rho[3];
  loss.Evaluate(0.0, rho);
  EXPECT_EQ(rho[0], 0.0);
  EXPECT_EQ(rho[1], 1.0);
  EXPECT_EQ(rho[2], -0.25);
  loss.Evaluate(4.0, rho);
  EXPECT_NEAR(rho[0], 4.0 * (1.0 - 0.36787944117144233), 1e-14);
  EXPECT_NEAR(rho[1], 0.36787944117144233, 1e-15);
  EXPECT_NEAR(rho[2], -0.25 * 0.36787944117144233, 1e-15);
  loss.Evaluate(1e6, rho);
  EXPECT_EQ(rho[0], 4.0);
  EXPECT_EQ(rho[1], 0.0);
}

TEST(WelschLoss, IsTheSquareForSmallResiduals) {
  const WelschLoss loss(1.0);
  double rho[3];
  loss.Evaluate(1e-12, rho);
  EXPECT_NEAR(rho[0] / 1e-12, 1.0, 1e-11);  // 1 - exp() would lose four digits here
}

TEST(WelschLoss, DerivativesMatchNumeric) {
  for (const double scale : {0.5, 1.0, std::sqrt(2.0), 3.0}) {
    const WelschLoss loss(scale);
    for (const double s : {0.01, 0.3, 1.0, 2.5, 9.0}) {
      const double h = 1e-5;
      double rho[3], above[3], below[3];
      loss.Evaluate(s, rho);
      loss.Evaluate(s + h, above);
      loss.Evaluate(s - h, below);
      EXPECT_NEAR(rho[1], (above[0] - below[0]) / (2.0 * h), 1e-8) << scale << " " << s;
      EXPECT_NEAR(rho[2], (above[1] - below[1]) / (2.0 * h), 1e-8) << scale << " " << s;
    }
  }
}

}  // namespace
}  // namespace radive
