// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/check_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "radive/io/trajectories/trajectory_io.h"

namespace radive {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

RecordedTrajectory ReadChecked(const std::string& text,
                               TrajectoryFormat format = TrajectoryFormat::kTum) {
  std::string error;
  const auto poses = ParseTrajectory(text, format, "file", &error);
  EXPECT_TRUE(poses) << error;
  return poses.value_or(RecordedTrajectory());
}

std::string ErrorOf(const std::string& text, TrajectoryFormat format = TrajectoryFormat::kTum) {
  std::string error;
  EXPECT_FALSE(ParseTrajectory(text, format, "file", &error)) << text;
  return error;
}

// Straight on with 10 m/s, a pose each 0.1 s, with one more line at the place of a pose.
RecordedTrajectory Drive(std::size_t replaced, const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < 20; ++i) {
    text += i == replaced ? line + "\n"
                          : std::to_string(i) + "e-1 " + std::to_string(i) + " 0 0 0 0 0 1\n";
  }
  return ReadChecked(text);
}

std::vector<std::string> Doubts(const RecordedTrajectory& poses) {
  return DoubtsAboutPoses(poses, /*has_stamps=*/true, /*has_rotations=*/true, "file");
}

TEST(CheckPoses, PositionsBeyondTheBoundAreAnError) {
  ReadChecked("0 1e9 0 0 0 0 0 1\n");
  EXPECT_EQ(ErrorOf("0 1 2 3 0 0 0 1\n1 0 -1.1e9 0 0 0 0 1\n"),
            "file:2: expected a position within 1e9 m, found 0 -1.1e+09 0");
  EXPECT_THAT(ErrorOf("0 1e200 0 0 0 0 0 1\n"), HasSubstr("file:1: expected a position"));
}

TEST(CheckPoses, QuaternionsFarFromUnitLengthAreAnError) {
  EXPECT_THAT(ErrorOf("0 0 0 0 0 0 0 0.49\n"), HasSubstr("found one of length 0.49"));
  EXPECT_THAT(ErrorOf("0 0 0 0 0 2.1 0 0\n"), HasSubstr("found one of length 2.1"));
}

TEST(CheckPoses, QuaternionsSomewhatOffAreCounted) {
  EXPECT_THAT(Doubts(ReadChecked("0 0 0 0 0 0 0 1.009\n1 0 0 0 0 0 0 0.991\n")), IsEmpty());
  EXPECT_THAT(Doubts(ReadChecked("0 0 0 0 0 0 0 1.02\n1 0 0 0 0 0 0 0.6\n2 0 0 0 0 0 0 0\n")),
              ElementsAre(HasSubstr("1 of 3 poses have a quaternion of length zero"),
                          HasSubstr("2 of 3 poses have a quaternion whose length")));
}

TEST(CheckPoses, MatricesThatAreNoRotationsAreAnError) {
  const auto format = TrajectoryFormat::kKitti;
  // R R^T - I has the one entry 1.03^2 - 1 = 0.0609, with 1.02 it is 0.0404.
  EXPECT_THAT(
      ErrorOf("1.03 0 0 1 0 1 0 2 0 0 1 3\n", format),
      HasSubstr("file:1: expected a rotation matrix, found one with ||R R^T - I|| = 0.060"));
  EXPECT_THAT(ErrorOf("-1 0 0 1 0 1 0 2 0 0 1 3\n", format), HasSubstr("a reflection"));
  EXPECT_THAT(
      DoubtsAboutPoses(ReadChecked("1.02 0 0 1 0 1 0 2 0 0 1 3\n", format), false, true, "file"),
      ElementsAre(HasSubstr("1 of 1 poses have a matrix")));
  EXPECT_THAT(
      DoubtsAboutPoses(ReadChecked("1.0004 0 0 1 0 1 0 2 0 0 1 3\n", format), false, true, "file"),
      IsEmpty());
}

TEST(CheckPoses, DecimalCommasAreAnError) {
  EXPECT_EQ(ErrorOf("# t x y z\n0 27,516 1,5 0,25 0,1 0,2 0,3 0,9\n"),
            "file:2: expected numbers with a decimal point, found '27,516'");
  std::string problem;
  EXPECT_TRUE(HasDecimalCommas("0,5;-1,5e-3;2,5;0", &problem));
  EXPECT_FALSE(HasDecimalCommas("1,2,3,4,5,6,7,8", &problem));
  EXPECT_FALSE(HasDecimalCommas("1, 2, 3, 4, 5, 6, 7, 8", &problem));
  EXPECT_FALSE(HasDecimalCommas("1,5 2,5 3,5 0.1", &problem));  // commas separate
  EXPECT_FALSE(HasDecimalCommas("1,5 2 3 4 5,5", &problem));
}

TEST(CheckPoses, SpikesAreDoubted) {
  EXPECT_THAT(Doubts(Drive(0, "0 0 0 0 0 0 0 1")), IsEmpty());
  // 9 m off; the neighbours are off by half of it.
  EXPECT_THAT(Doubts(Drive(7, "0.7 16 0 0 0 0 0 1")),
              ElementsAre(HasSubstr("positions of 3 of 20 poses lie off those of both neighbours, "
                                    "most of all pose 8 by 9 m")));
  EXPECT_THAT(Doubts(Drive(7, "0.7 7.49 0 0 0 0 0 1")), IsEmpty());
  EXPECT_THAT(Doubts(Drive(7, "0.7 7 0 0 0 0 0.707 0.707")),
              ElementsAre(HasSubstr("rotations of 3 of 20 poses")));
  // A gap of 2 s in a bend of 1 m/s^2 takes no more than a car does.
  RecordedTrajectory bend;
  for (const double t : {0.0, 0.1, 0.2, 2.2, 4.2, 4.3, 4.4}) {
    RecordedPose pose;
    pose.stamp_s = t;
    pose.stamp_ns = static_cast<std::int64_t>(t * 1e9);
    pose.T_world_body.translation = {10.0 * t, 0.5 * t * t, 0.0};
    bend.push_back(pose);
  }
  EXPECT_THAT(Doubts(bend), IsEmpty());
  // Standing, then at once at 20 m/s: 1 m off its neighbours at the start, but no pose is wrong.
  RecordedTrajectory start;
  for (int k = -5; k <= 5; ++k) {
    RecordedPose pose;
    pose.stamp_ns = 100000000LL * (k + 5);
    pose.stamp_s = 0.1 * (k + 5);
    pose.T_world_body.translation = {2.0 * std::max(0, k), 0.0, 0.0};
    start.push_back(pose);
  }
  EXPECT_THAT(Doubts(start), IsEmpty());
  // A jump for good is told, by the poses before and behind it.
  for (std::size_t i = 9; i < start.size(); ++i) start[i].T_world_body.translation.y() = 3.0;
  EXPECT_THAT(Doubts(start), ElementsAre(HasSubstr("positions of 2 of 11 poses")));
}

// Around a circle of 20 m radius, a metre from pose to pose: q = (0, 0, sin, cos) of half the
// heading. Straight ahead both orders follow the motion.
TEST(CheckPoses, QuaternionsWithTheScalarFirstAreDoubted) {
  const auto drive = [](bool is_scalar_first, double turn) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
      const double heading = turn * i;
      const double x = turn == 0.0 ? i : std::sin(heading) / turn;
      const double y = turn == 0.0 ? 0.0 : (1.0 - std::cos(heading)) / turn;
      const std::string s = std::to_string(std::sin(heading / 2.0));
      const std::string c = std::to_string(std::cos(heading / 2.0));
      text += std::to_string(i) + " " + std::to_string(x) + " " + std::to_string(y) + " 0 " +
              (is_scalar_first ? c + " 0 0 " + s : "0 0 " + s + " " + c) + "\n";
    }
    return ReadChecked(text);
  };
  EXPECT_THAT(Doubts(drive(true, 0.05)),
              ElementsAre(HasSubstr("would if the quaternions were written as qw qx qy qz")));
  EXPECT_THAT(Doubts(drive(false, 0.05)), IsEmpty());
  EXPECT_THAT(Doubts(drive(true, 0.0)), IsEmpty());
  // Headings that have nothing to do with the motion.
  RecordedTrajectory other = drive(false, 0.05);
  for (std::size_t i = 0; i < other.size(); ++i) {
    other[i].T_world_body.rotation =
        Eigen::AngleAxisd(1.7 * static_cast<double>(i), Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
  }
  EXPECT_THAT(Doubts(other), Not(Contains(HasSubstr("qw qx qy qz"))));
}

TEST(CheckPoses, StampsThatGoBackAreDoubted) {
  EXPECT_THAT(Doubts(ReadChecked("5 0 0 0 0 0 0 1\n6 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n")),
              ElementsAre("file: the stamps of 1 of 3 poses go back, the first is that of pose 3"));
}

}  // namespace
}  // namespace radive
