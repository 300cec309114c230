// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/result_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "radive/pipeline/result_rows.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::ReadFile;
using testing::ScratchFolder;

// A quarter turn to the left at (1, 2, 3).
OdometryResult QuarterTurn() {
  OdometryResult result;
  result.index = 7;
  result.stamp_ns = 1'706'001'762'099'999'905;
  result.status = OdometryResult::Status::kPredicted;
  result.reason = "few returns, 3 of 10";
  result.T_world_body = {QuaternionFromRotationVector({0.0, 0.0, 1.5707963267948966}),
                         {1.0, 2.0, 3.0}};
  result.covariance.diagonal() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
  result.covariance(0, 5) = result.covariance(5, 0) = -0.25;
  result.ego_velocity.valid = true;
  result.ego_velocity.v_radar = {10.0, -0.5, 0.125};
  result.times_ms.total = 2.5;
  return result;
}

std::size_t CountCommas(const std::string& line) {
  std::size_t count = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++count;
  }
  return count;
}

TEST(ResultRows, TrajectoriesHaveNineDecimalsAndTheExactStamp) {
  EXPECT_EQ(TumRow(QuarterTurn()),
            "1706001762.099999905 1.000000000 2.000000000 3.000000000 0.000000000 0.000000000 "
            "0.707106781 0.707106781\n");
  EXPECT_EQ(KittiRow(QuarterTurn()),
            "0.000000000 -1.000000000 0.000000000 1.000000000 "
            "1.000000000 0.000000000 0.000000000 2.000000000 "
            "0.000000000 0.000000000 1.000000000 3.000000000\n");
}

TEST(ResultRows, TablesHaveAColumnForEachName) {
  OdometryResult result = QuarterTurn();
  result.num_returns = 50;
  result.num_kept = 14;
  result.dropped = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(result.num_kept + result.dropped.Sum(), result.num_returns);
  const std::string row = ScansRow(result, 2);
  EXPECT_THAT(ScansHeader(),
              HasSubstr(",returns,kept,not_finite,no_doppler,out_of_range,out_of_view,no_velocity,"
                        "moving,occluded,behind_nearest,gaussians,"));
  EXPECT_EQ(CountCommas(row), CountCommas(ScansHeader()));
  EXPECT_EQ(CountCommas(ScansHeader()) + 1, 29u + 6u + 21u);
  EXPECT_THAT(
      row,
      HasSubstr("7,1706001762099999905,2,predicted,\"few returns, 3 of 10\",0,0,50,14,1,2,3,"
                "4,5,6,7,8,0,0,0,0,1,,0,0,0,10,-0.5,0.125,"));
  // The last six columns of the first row of the triangle: rx against all, then ry against ry.
  EXPECT_THAT(row, HasSubstr(",1,0,0,0,0,-0.25,2,"));
  EXPECT_THAT(ScansHeader(), HasSubstr("pose_cov_rx_tz,pose_cov_ry_ry"));
  EXPECT_EQ(TimingRow(QuarterTurn(), 0.5),
            "7,0.5000,0.0000,0.0000,0.0000,0.0000,0.0000,2.5000,3.0000\n");
  EXPECT_EQ(CountCommas(TimingHeader()), 8u);
}

TEST(MapThinner, KeepsTheFirstPointOfACube) {
  const std::vector<Eigen::Vector3d> points = {
      {0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, {-0.1, 0.1, 0.1}, {1.1, 0.1, 0.1}};
  MapThinner map(1.0);
  map.Add({points[0], points[1]});
  map.Add({points[2], points[3], points[0]});
  ASSERT_EQ(map.points().size(), 3u);
  EXPECT_EQ(map.points()[0], points[0]);
  EXPECT_EQ(map.points()[1], points[2]);
  EXPECT_EQ(map.points()[2], points[3]);
  MapThinner all(0.0);
  all.Add(points);
  EXPECT_EQ(all.points().size(), 4u);
}

TEST(ResultWriter, FilesGetTheirNamesAtTheEndOnly) {
  const ScratchFolder scratch;
  const auto folder = scratch.path() / "a" / "b";
  std::string error;
  ResultWriter writer;
  ASSERT_TRUE(writer.Open(folder, &error)) << error;
  ASSERT_TRUE(writer.AddScan({}, QuarterTurn(), &error)) << error;
  EXPECT_FALSE(std::filesystem::exists(folder / "trajectory_tum.txt"));
  EXPECT_EQ(ReadFile(folder / ".trajectory_tum.txt.partial"), TumRow(QuarterTurn()));
  ASSERT_TRUE(writer.Publish(&error)) << error;
  EXPECT_EQ(ReadFile(folder / "trajectory_tum.txt"), TumRow(QuarterTurn()));
  EXPECT_EQ(ReadFile(folder / "trajectory_kitti.txt"), KittiRow(QuarterTurn()));
  EXPECT_EQ(ReadFile(folder / "scans.csv"), ScansHeader() + ScansRow(QuarterTurn(), 0));
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
  }
}

TEST(ResultWriter, LeavesFoldersWithOtherFilesAlone) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "thesis.tex") << "years of work";
  std::string error;
  EXPECT_FALSE(ResultWriter().Open(scratch.path(), &error));
  EXPECT_THAT(error, HasSubstr("it holds thesis.tex"));
  EXPECT_FALSE(ResultWriter().Open(scratch.path() / "thesis.tex", &error));
  EXPECT_THAT(error, HasSubstr("must be a folder, is a file"));
  EXPECT_EQ(ReadFile(scratch.path() / "thesis.tex"), "years of work");
}

TEST(ResultWriter, LeavesFoldersWithTheNameOfAResultAlone) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "map.ply");
  std::ofstream(scratch.path() / "map.ply" / "mine") << "text";
  ResultWriter writer;
  std::string error;
  EXPECT_FALSE(writer.Open(scratch.path(), &error));
  EXPECT_THAT(error, HasSubstr("it holds map.ply"));
  EXPECT_EQ(ReadFile(scratch.path() / "map.ply" / "mine"), "text");
}

TEST(ResultWriter, ReplacesEarlierResults) {
  const ScratchFolder scratch;
  std::string error;
  for (int run = 0; run < 2; ++run) {
    ResultWriter writer;
    ASSERT_TRUE(writer.Open(scratch.path(), &error)) << error;
    if (run == 1) {
      ASSERT_TRUE(writer.AddScan({}, QuarterTurn(), &error)) << error;
    } else {
      ASSERT_TRUE(writer.WriteText("map.ply", "points", &error)) << error;
    }
    ASSERT_TRUE(writer.Publish(&error)) << error;
    EXPECT_EQ(std::filesystem::exists(scratch.path() / "map.ply"), run == 0);
  }
  EXPECT_EQ(ReadFile(scratch.path() / "trajectory_tum.txt"), TumRow(QuarterTurn()));
}

TEST(ResultWriter, RefusesAFolderThatAnotherWriterHas) {
  const ScratchFolder scratch;
  std::string error;
  ResultWriter first, second;
  ASSERT_TRUE(first.Open(scratch.path(), &error)) << error;
  EXPECT_FALSE(second.Open(scratch.path(), &error));
  EXPECT_EQ(error, scratch.path().string() + ": another program is writing into this folder");
}

TEST(ResultWriter, NamesAFolderThatCannotBeMade) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "";
  std::string error;
  EXPECT_FALSE(ResultWriter().Open(scratch.path() / "file" / "results", &error));
  EXPECT_THAT(error, HasSubstr("file/results: cannot create the output folder: "));
}

// A full disk, played by a device that refuses every byte.
TEST(ResultWriter, NamesTheFileThatDoesNotFitAndKeepsEarlierResults) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
  const ScratchFolder scratch;
  std::filesystem::create_symlink("/dev/full", scratch.path() / ".scans.csv.partial");
  std::ofstream(scratch.path() / "trajectory_tum.txt") << "earlier";
  std::string error;
  ResultWriter writer;
  ASSERT_TRUE(writer.Open(scratch.path(), &error)) << error;
  EXPECT_FALSE(writer.AddScan({}, QuarterTurn(), &error));
  EXPECT_THAT(error, HasSubstr("scans.csv.partial: cannot be written: No space left on device"));
  EXPECT_FALSE(writer.Publish(&error));
  EXPECT_THAT(error, HasSubstr("scans.csv.partial: cannot be written: No space left on device"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "scans.csv"));
  EXPECT_EQ(ReadFile(scratch.path() / "trajectory_tum.txt"), "earlier");
  EXPECT_EQ(ReadFile(scratch.path() / ".trajectory_tum.txt.partial"), TumRow(QuarterTurn()));
}

}  // namespace
}  // namespace radive
