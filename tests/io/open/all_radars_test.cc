// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/all_radars.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/io/points/point_file_writer.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;
using ::testing::Pair;

class AllRadars : public ::testing::Test {
 protected:
  AllRadars() { options_.radar = "all"; }

  static std::vector<RadarReturn> ReturnsAt(double x) {
    std::vector<RadarReturn> returns(3);
    for (RadarReturn& one : returns) one = {{x, 1, 0.5}, -1, 20};
    return returns;
  }

  // Number and x of the first return of each scan, in the order they come.
  std::vector<std::pair<int, double>> Read() {
    std::string error;
    const auto source = OpenScanSource(folder_.string(), options_, &error);
    if (source == nullptr) {
      ADD_FAILURE() << error;
      return {};
    }
    std::vector<std::pair<int, double>> rows;
    for (const RadarScan& scan : testing::ReadAll(source.get())) {
      rows.emplace_back(scan.radar, scan.returns.at(0).position.x());
    }
    return rows;
  }

  std::string Error() {
    std::string error;
    EXPECT_EQ(OpenScanSource(folder_.string(), options_, &error), nullptr);
    return error;
  }

  const testing::TempFolder folder_;
  InputOptions options_;
};

TEST_F(AllRadars, OfRadarScenesHaveTheirOwnNumbers) {
  const std::string names = "timestamp_rad,first_point,num_points\n";
  folder_.Write("radar2_scans.csv", names + "0.1,0,1\n0.3,0,1\n");
  folder_.Write("radar2_points.bin", Floats({5.0, 0.0, 1.0, 0.0, 11.0}));
  folder_.Write("radar4_scans.csv", names + "0.2,0,1\n");
  folder_.Write("radar4_points.bin", Floats({7.0, 0.0, 1.0, 0.0, 11.0}));
  EXPECT_THAT(Read(), ElementsAre(Pair(2, 5.0), Pair(4, 7.0), Pair(2, 5.0)));
  std::filesystem::remove(folder_.path() / "radar4_points.bin");
  EXPECT_THAT(Error(), HasSubstr("radar4_points.bin"));
  options_.format = InputOptions::Format::kRadarScenes;
  std::filesystem::remove_all(folder_.path() / "radar2_scans.csv");
  std::filesystem::remove_all(folder_.path() / "radar4_scans.csv");
  EXPECT_THAT(Error(), HasSubstr("expected radar1_scans.csv, radar2_scans.csv, ..., found none"));
}

// Its records: 29 bytes each, and different ones.
TEST_F(AllRadars, OfHerculesAreTheContinentalAndTheAeva) {
  folder_.Write("Radar/Continental/1700000000000000000.bin",
                RecordBytes(ReturnsAt(10), KnownLayout("hercules29")));
  folder_.Write("Radar/Continental/1700000000100000000.bin",
                RecordBytes(ReturnsAt(11), KnownLayout("hercules29")));
  const std::string record = Floats({30, 1, 0, 0.5, -2}) + std::string(9, '\0');
  folder_.Write("LiDAR/Aeva/1700000000050000000.bin", record + record);
  EXPECT_THAT(Read(), ElementsAre(Pair(1, 10.0), Pair(2, 30.0), Pair(1, 11.0)));
}

TEST_F(AllRadars, OfSnailAreTheArs548AndTheEagle) {
  folder_.Write("ars548/points/1700000000.000000000.pcd",
                PcdBytes(ReturnsAt(10), PcdEncoding::kBinary));
  folder_.Write("ars548/points/1700000000.200000000.pcd",
                PcdBytes(ReturnsAt(11), PcdEncoding::kBinary));
  folder_.Write("eagleg7/enhanced/1700000000.100000000.pcd",
                PcdBytes(ReturnsAt(30), PcdEncoding::kBinary));
  EXPECT_THAT(Read(), ElementsAre(Pair(1, 10.0), Pair(2, 30.0), Pair(1, 11.0)));
  // Another choice, and order, of folders.
  folder_.Write("eagleg7/pcl/1700000000.300000000.pcd",
                PcdBytes(ReturnsAt(40), PcdEncoding::kBinary));
  options_.format = InputOptions::Format::kPcd;
  options_.folder = "[eagleg7/pcl, ars548/points]";
  EXPECT_THAT(Read(), ElementsAre(Pair(2, 10.0), Pair(2, 11.0), Pair(1, 40.0)));
}

TEST_F(AllRadars, OfABagAreTheTopicsInTheirOrder) {
  std::string error;
  auto writer = Ros1BagWriter::Create(
      folder_.path() / "a.bag", {Compression::kNone, /*index=*/true, 1000}, &error);
  ASSERT_NE(writer, nullptr) << error;
  const int front = writer->AddTopic({"/front", "sensor_msgs/PointCloud2", "ros1", {}});
  const int rear = writer->AddTopic({"/rear", "sensor_msgs/PointCloud2", "ros1", {}});
  for (int k = 0; k < 3; ++k) {
    RadarScan scan;
    scan.stamp_ns = 1000000000 + k * std::int64_t{50000000};
    scan.returns = ReturnsAt(10 + k);
    ASSERT_TRUE(writer->Write(
        k == 1 ? rear : front, scan.stamp_ns, EncodePointCloud2(scan, "ros1", "radar"), &error));
  }
  ASSERT_TRUE(writer->Close(&error)) << error;
  options_.topic = "[/rear, /front]";
  EXPECT_THAT(Read(), ElementsAre(Pair(2, 10.0), Pair(1, 11.0), Pair(2, 12.0)));
  options_.topic = "/front";
  EXPECT_THAT(Error(),
              HasSubstr("input.radar is all, expected a list of topics in input.topic: "
                        "[/one, /other], found one"));
}

TEST_F(AllRadars, SaysThatThereIsNothingToChooseFrom) {
  folder_.Write("000000.pcd", PcdBytes(ReturnsAt(10), PcdEncoding::kBinary));
  EXPECT_THAT(Error(), HasSubstr("expected a list of folders in input.folder: [one, other]"));
}

}  // namespace
}  // namespace radive
