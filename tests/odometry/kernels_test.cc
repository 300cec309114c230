// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Drives estimated with the kernels for any processor and with those for this one.

#include "radive/kernels/kernels.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/simulated_drive.h"
#include "tests/with_kernels.h"

namespace radive {
namespace {

class DriveWithAllKernels : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Sensors,
                         DriveWithAllKernels,
                         ::testing::Values("street_sparse", "street_planar", "street_dense"),
                         [](const auto& scenario) { return std::string(scenario.param); });

TEST_P(DriveWithAllKernels, EndsAtTheSamePlace) {
  const testing::Drive drive = testing::SimulateDrive(testing::Scenario(GetParam(), 60));
  std::vector<std::vector<OdometryResult>> estimates;
  for (const Kernels* kernels : AvailableKernels()) {
    const testing::WithKernels with_kernels(*kernels);
    estimates.push_back(testing::RunOdometry(testing::OptionsFor(drive.simulation), drive.scans));
  }
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const Rigid3 T =
        estimates.front()[i].T_world_radar.Inverse() * estimates.back()[i].T_world_radar;
    EXPECT_LE(T.translation.norm(), 1e-6) << i;
    EXPECT_LE(RotationVector(T.rotation).norm(), 1e-7) << i;
  }
  EXPECT_GT(estimates.front().back().T_world_radar.translation.norm(), 0.5);
}

}  // namespace
}  // namespace radive
