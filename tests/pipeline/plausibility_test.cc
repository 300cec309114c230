// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// 20 scans at `rate` [Hz], whose positions are multiplied with `unit`; poses that move at 8 m/s
// times `unit`. The median range of StaticScan() is 30 m.
std::vector<std::string> WarningsOf(double unit, double rate) {
  Plausibility plausibility;
  for (int i = 0; i < 20; ++i) {
    const auto stamp_ns = static_cast<std::int64_t>(1e9 * i / rate);
    RadarScan scan = testing::StaticScan(stamp_ns, {8.0, 0.0, 0.0}, 1.0);
    for (RadarReturn& radar_return : scan.returns) radar_return.position *= unit;
    plausibility.AddScan(scan);
    OdometryResult result;
    result.stamp_ns = stamp_ns;
    result.status = OdometryResult::Status::kRegistered;
    result.T_world_body.translation.x() = unit * 0.8 * i;
    plausibility.AddPose(result);
  }
  return plausibility.Warnings();
}

TEST(Plausibility, SaysNothingOfMetresAndSeconds) {
  EXPECT_THAT(WarningsOf(1.0, 10.0), IsEmpty());
  EXPECT_THAT(WarningsOf(4.0, 100.0), Not(Contains(HasSubstr("farther"))));
}

TEST(Plausibility, NamesTheUnitOfPositions) {
  EXPECT_THAT(WarningsOf(1000.0, 10.0),
              ElementsAre(HasSubstr("farther than 3e+04 m: are the positions in millimetres?"),
                          HasSubstr("the poses move at 8000 m/s")));
  EXPECT_THAT(WarningsOf(100.0, 10.0),
              ElementsAre(HasSubstr("farther than 3000 m: are the positions in centimetres?"),
                          HasSubstr("the poses move at 800 m/s")));
}

// Microseconds taken for nanoseconds.
TEST(Plausibility, NamesAnImpossibleRate) {
  EXPECT_THAT(WarningsOf(1.0, 10000.0),
              ElementsAre(HasSubstr("the stamps say 1e+04 scans per second"),
                          HasSubstr("the poses move at 8000 m/s")));
  EXPECT_THAT(WarningsOf(1.0, 0.01), ElementsAre(HasSubstr("the stamps say 0.01 scans")));
}

}  // namespace
}  // namespace radive
