// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/predicted_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Scans 0.1 s apart: r registered, p predicted, s standing.
std::vector<std::string> WarningsOf(const std::string& drive) {
  PredictedPoses poses;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    OdometryResult result;
    result.stamp_ns = 100'000'000 * static_cast<std::int64_t>(i);
    result.status = drive[i] == 'r'   ? OdometryResult::Status::kRegistered
                    : drive[i] == 's' ? OdometryResult::Status::kStanding
                                      : OdometryResult::Status::kPredicted;
    if (drive[i] == 'p') result.reason = "3 returns left";
    poses.Add(result, "scan " + std::to_string(i));
  }
  poses.Finish();
  return poses.TakeWarnings();
}

TEST(PredictedPoses, SaysNothingOfShortStretches) {
  EXPECT_THAT(WarningsOf(""), IsEmpty());
  EXPECT_THAT(WarningsOf(std::string(40, 'r')), IsEmpty());
  EXPECT_THAT(WarningsOf(std::string(40, 'r') + std::string(21, 'p') + "r"), IsEmpty());  // 2.0 s
  EXPECT_THAT(WarningsOf(std::string(40, 's')), IsEmpty());
}

TEST(PredictedPoses, NamesTheFirstScanTheLengthAndTheReasonOfALongOne) {
  EXPECT_THAT(WarningsOf(std::string(40, 'r') + std::string(22, 'p') + "r"),
              ElementsAre("scan 40: from here on 22 scans (2.1 s) were not registered, and their "
                          "poses are predicted: 3 returns left"));
  // At the end of the drive too.
  EXPECT_THAT(WarningsOf(std::string(40, 'r') + std::string(30, 'p')),
              ElementsAre(HasSubstr("30 scans (2.9 s)")));
}

TEST(PredictedPoses, CountsTheOthers) {
  const std::string stretch = "rr" + std::string(22, 'p');
  EXPECT_THAT(WarningsOf(stretch + stretch + stretch),
              ElementsAre(HasSubstr("scan 2: from here on 22 scans"),
                          "and 2 more: stretches of predicted poses"));
}

TEST(PredictedPoses, ManyShortStretchesAreOneWarning) {
  std::string drive;
  for (int i = 0; i < 10; ++i) drive += "rpp";
  EXPECT_THAT(WarningsOf(drive),
              ElementsAre("20 of 30 scans were not registered, and their poses are predicted; the "
                          "first: scan 1: 3 returns left"));
}

}  // namespace
}  // namespace radive
