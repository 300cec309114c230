// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/trajectory_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace radive {
namespace {

using ::testing::HasSubstr;

class TrajectoryIo : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& text) {
    const std::filesystem::path file = Path("input.txt");
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  // A folder of each test's own, because tests run side by side.
  static std::filesystem::path Path(const std::string& name) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) /
                                         (std::string("trajectory_io_") + test->name());
    std::filesystem::create_directories(folder);
    return folder / name;
  }

  static std::string Content(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }

  // Reads a file of this text, which must be refused, and returns the message.
  std::string ErrorOf(const std::string& text, TrajectoryFormat format) {
    std::string error;
    EXPECT_FALSE(ReadTrajectory(Write(text), format, &error));
    return error;
  }
};

TEST_F(TrajectoryIo, ReadsTum) {
  // 90 degrees about z: x turns to y.
  std::string error;
  const auto trajectory =
      ReadTrajectory(Write("# t x y z qx qy qz qw\n"
                           "10.000000001 1 2 3 0 0 0.70710678118654752 0.70710678118654752\n"
                           "11.5 -1.5e1 0 0 0 0 0 1\n"),
                     TrajectoryFormat::kTum,
                     &error);
  ASSERT_TRUE(trajectory) << error;
  ASSERT_EQ(trajectory->size(), 2u);
  const RecordedPose& first = trajectory->front();
  EXPECT_EQ(first.stamp_ns, 10000000001);
  EXPECT_EQ(first.stamp_s, 10.000000001);
  EXPECT_EQ(first.T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((first.T_world_body.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_EQ(trajectory->back().stamp_ns, 11500000000);
  EXPECT_EQ(trajectory->back().T_world_body.translation.x(), -15.0);
}

TEST_F(TrajectoryIo, ReadsTumOfOtherHabits) {
  std::string error;
  const auto trajectory = ReadTrajectory(Write("\xEF\xBB\xBF# byte order mark\r\n"
                                               "\r\n"
                                               "  1.0\t1,2,  3 0\t0 0 1  \r\n"
                                               "   # indented remark\n"
                                               "1706001762099999905 +4 5 6 0 0 0 1"),
                                         TrajectoryFormat::kTum,
                                         &error);
  ASSERT_TRUE(trajectory) << error;
  ASSERT_EQ(trajectory->size(), 2u);
  EXPECT_EQ((*trajectory)[0].T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ((*trajectory)[1].stamp_ns, 1706001762099999905);
  EXPECT_NEAR((*trajectory)[1].stamp_s, 1706001762.0999999, 1e-6);
  EXPECT_EQ((*trajectory)[1].T_world_body.translation, Eigen::Vector3d(4, 5, 6));
}

TEST_F(TrajectoryIo, NormalisesQuaternionsAndTakesZeroForIdentity) {
  std::string error;
  const auto trajectory =
      ReadTrajectory(Write("0 0 0 0 0 0 -1 -1\n1 0 0 0 0 0 0 0\n"), TrajectoryFormat::kTum, &error);
  ASSERT_TRUE(trajectory) << error;
  const Eigen::Matrix3d& R = (*trajectory)[0].T_world_body.rotation;
  EXPECT_NEAR((R.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_EQ((*trajectory)[1].T_world_body.rotation, Eigen::Matrix3d::Identity());
}

TEST_F(TrajectoryIo, ReadsKittiMatricesAsTheyAre) {
  std::string error;
  const auto trajectory =
      ReadTrajectory(Write("0.0000001 -1 0 5 1 0 0 6 0 0 1 7\n"), TrajectoryFormat::kKitti, &error);
  ASSERT_TRUE(trajectory) << error;
  Eigen::Matrix3d R;
  R << 0.0000001, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_EQ(trajectory->front().T_world_body.rotation, R);
  EXPECT_EQ(trajectory->front().T_world_body.translation, Eigen::Vector3d(5, 6, 7));
}

TEST_F(TrajectoryIo, ReadsEurocWithScalarFirstAndMoreColumns) {
  std::string error;
  const auto trajectory = ReadTrajectory(
      Write("#timestamp, p_x [m], ...\n"
            "1403715529107142912,1,2,3,0.70710678118654752,0,0,0.70710678118654752,9,9,9\n"),
      TrajectoryFormat::kEuroc,
      &error);
  ASSERT_TRUE(trajectory) << error;
  const RecordedPose& pose = trajectory->front();
  EXPECT_EQ(pose.stamp_ns, 1403715529107142912);
  EXPECT_EQ(pose.stamp_s, 1403715529107142912.0 / 1e9);
  EXPECT_EQ(pose.T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((pose.T_world_body.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
}

TEST_F(TrajectoryIo, NamesFileLineAndExpectation) {
  const std::string good = "# remark\n0 0 0 0 0 0 0 1\n";
  EXPECT_THAT(ErrorOf(good + "1 0 0 0 0 0 1\n", TrajectoryFormat::kTum),
              HasSubstr("input.txt:3: expected 8 numbers 't x y z qx qy qz qw', found 7"));
  EXPECT_THAT(ErrorOf(good + "1 0 0 0 0 0 0 1 0\n", TrajectoryFormat::kTum), HasSubstr("found 9"));
  EXPECT_THAT(ErrorOf(good + "1 0 0 0 0 0 0 1\n1 0 zwei 0 0 0 0 1\n", TrajectoryFormat::kTum),
              HasSubstr("input.txt:4: expected a finite number in column 3"));
  EXPECT_THAT(ErrorOf(good, TrajectoryFormat::kKitti), HasSubstr("input.txt:2: expected 12"));
  EXPECT_THAT(ErrorOf("1403715529107142912,1,2,3,1,0,0\n", TrajectoryFormat::kEuroc),
              HasSubstr("input.txt:1: expected 8 numbers 't_ns x y z qw qx qy qz', found 7"));
}

TEST_F(TrajectoryIo, RefusesNumbersThatAreNotFinite) {
  for (const std::string word : {"nan", "inf", "-inf", "1e999", "+-1", "+", "1x"}) {
    EXPECT_THAT(ErrorOf("0 0 0 " + word + " 0 0 0 1\n", TrajectoryFormat::kTum),
                HasSubstr("column 4 of 't x y z qx qy qz qw', found '" + word + "'"));
  }
  EXPECT_THAT(ErrorOf("1e20 0 0 0 0 0 0 1\n", TrajectoryFormat::kTum), HasSubstr("146 years"));
}

TEST_F(TrajectoryIo, RefusesMissingAndEmptyFilesAndFolders) {
  std::string error;
  EXPECT_FALSE(ReadTrajectory(Path("absent.txt"), TrajectoryFormat::kTum, &error));
  EXPECT_THAT(error, HasSubstr("absent.txt: cannot be opened"));
  EXPECT_FALSE(ReadTrajectory(Path("x").parent_path(), TrajectoryFormat::kTum, &error));
  EXPECT_THAT(error, HasSubstr("cannot be opened"));
  EXPECT_THAT(ErrorOf("# nothing\n\n", TrajectoryFormat::kTum), HasSubstr("holds no poses"));
}

Trajectory TwoPoses() {
  const double half = std::sqrt(0.5);
  return {{1706001762099999905, Rigid3()},
          {1706001762199999905,
           Rigid3(Eigen::Quaterniond(half, 0, 0, half), Eigen::Vector3d(1.5, -2, 1234567.25))}};
}

TEST_F(TrajectoryIo, WritesTum) {
  std::string error;
  ASSERT_TRUE(WriteTumTrajectory(Path("out.txt"), TwoPoses(), &error)) << error;
  EXPECT_EQ(Content(Path("out.txt")),
            "1706001762.099999905 0.000000000 0.000000000 0.000000000 "
            "0.000000000 0.000000000 0.000000000 1.000000000\n"
            "1706001762.199999905 1.500000000 -2.000000000 1234567.250000000 "
            "0.000000000 0.000000000 0.707106781 0.707106781\n");
  EXPECT_FALSE(std::filesystem::exists(Path("out.txt.part")));
}

TEST_F(TrajectoryIo, WritesKitti) {
  std::string error;
  std::ofstream(Path("out.txt")) << KittiLine(TwoPoses()[1]) << "\n";
  const auto read = ReadTrajectory(Path("out.txt"), TrajectoryFormat::kKitti, &error);
  ASSERT_TRUE(read) << error;
  EXPECT_NEAR(
      (read->front().T_world_body.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 2e-9);
  EXPECT_EQ(read->front().T_world_body.translation, Eigen::Vector3d(1.5, -2, 1234567.25));
}

TEST_F(TrajectoryIo, WrittenTumReadsBackWithExactStamps) {
  std::string error;
  ASSERT_TRUE(WriteTumTrajectory(Path("out.txt"), TwoPoses(), &error)) << error;
  const auto read = ReadTrajectory(Path("out.txt"), TrajectoryFormat::kTum, &error);
  ASSERT_TRUE(read) << error;
  const RecordedTrajectory direct = ToRecordedTrajectory(TwoPoses());
  const Trajectory back = ToTrajectory(*read);
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back[i].stamp_ns, TwoPoses()[i].stamp_ns);
    EXPECT_EQ((*read)[i].stamp_s, direct[i].stamp_s);
    EXPECT_LT(back[i].T_world_body.rotation.angularDistance(TwoPoses()[i].T_world_body.rotation),
              1e-8);
  }
}

TEST_F(TrajectoryIo, SaysWhereItCannotWrite) {
  std::string error;
  EXPECT_FALSE(WriteTumTrajectory(Path("absent") / "out.txt", TwoPoses(), &error));
  EXPECT_THAT(error, HasSubstr("out.txt.part: cannot be written"));
}

}  // namespace
}  // namespace radive
