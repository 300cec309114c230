// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/detect_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/bags/bag_files.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::AllOf;
using testing::Floats;
using Format = InputOptions::Format;
using ::testing::HasSubstr;
using testing::TempFolder;

constexpr char kStamp[] = "1693922345123456789";

struct Found {
  Format format;
  std::string layout;
  std::string reason;
  std::string error;
};

Found Detect(const std::filesystem::path& path, InputOptions options = InputOptions()) {
  Found found;
  DetectFormat(path, &options, &found.reason, &found.error);
  found.format = options.format;
  found.layout = options.layout;
  return found;
}

TEST(DetectFormat, FilesByTheirFirstBytes) {
  const TempFolder folder;
  const std::pair<std::string, Format> cases[] = {
      {"#ROSBAG V2.0\nabc", Format::kRosbag1},
      {"\x89MCAP0\r\nabc", Format::kMcap},
      {std::string("SQLite format 3\0abc", 19), Format::kRosbag2},
      {"\x93NUMPY", Format::kNpy},
      {"ply\nformat", Format::kPly},
  };
  for (const auto& [bytes, format] : cases) {
    folder.Write("some.thing", bytes);
    EXPECT_EQ(Detect(folder.path() / "some.thing").format, format) << bytes;
  }
  for (const auto& [name, format] : {std::pair("a.pcd", Format::kPcd),
                                     std::pair("a.csv", Format::kCsv),
                                     std::pair("radar_seqs-0_samples-3.json", Format::kRaFlow)}) {
    folder.Write(name, "something");
    EXPECT_EQ(Detect(folder.path() / name).format, format) << name;
  }
}

TEST(DetectFormat, WhatTheSimulatorWrites) {
  const TempFolder folder;
  folder.Write("radar/000000.bin", Floats({1, 2, 3, 4, 5}));
  EXPECT_EQ(Detect(folder.path()).layout, "");  // might be anything
  folder.Write("scenario.json", "{}");
  const Found found = Detect(folder.path());
  EXPECT_EQ(found.format, Format::kRaw);
  EXPECT_EQ(found.layout, "xyzdp5");
  EXPECT_THAT(found.reason, HasSubstr("radive_simulate: *.bin in "));
}

TEST(DetectFormat, FilesThatAreNotWhatTheySay) {
  const TempFolder folder;
  folder.Write("a.bag", "no bag");
  EXPECT_THAT(Detect(folder.path() / "a.bag").error,
              AllOf(HasSubstr("a.bag: the name ends in .bag"), HasSubstr("found 'no bag'")));
  folder.Write("b.bag", testing::LfsPointer());
  EXPECT_THAT(Detect(folder.path() / "b.bag").error, HasSubstr("a Git-LFS pointer"));
  folder.Write("c.jpg", "\xFF\xD8");
  EXPECT_THAT(Detect(folder.path() / "c.jpg").error,
              HasSubstr("expected a bag (.bag, .mcap, .db3), points (.pcd,"));
  EXPECT_THAT(Detect(folder.path() / "absent").error, HasSubstr("does not exist"));
  EXPECT_THAT(Detect("/dev/null").error, HasSubstr("is neither file nor folder"));
}

TEST(DetectFormat, FoldersByWhatTheyHold) {
  struct Case {
    const char* file;
    Format format;
    const char* layout;
    const char* reason;
  };
  const std::string nanoseconds = std::string(kStamp) + ".bin";
  const std::string continental = "Radar/Continental/" + nanoseconds;
  const std::string nested = "Continental_data/Radar/Continental/" + nanoseconds;
  const std::string aeva = "LiDAR/Aeva/" + nanoseconds;
  const Case cases[] = {
      {"a_2.bag", Format::kRosbag1, "", "holds 1 bag, a_2.bag"},
      {"drive_0.mcap", Format::kMcap, "", "holds 1 bag, drive_0.mcap"},
      {"DRIVE_0.MCAP", Format::kMcap, "", "DRIVE_0.MCAP"},
      {"run_0.bag.active", Format::kRosbag1, "", "run_0.bag.active"},
      {"drive_0.db3.zstd", Format::kRosbag2, "", "drive_0.db3.zstd"},
      {"radar/0001.PCD", Format::kPcd, "", "1 files *.pcd"},
      {"drive_0.db3", Format::kRosbag2, "", "holds 1 bag, drive_0.db3"},
      {"radar2_scans.csv", Format::kRadarScenes, "", "radar2_scans.csv"},
      {"train/radar_seqs-0_samples-3.json", Format::kRaFlow, "", "RaFlow"},
      {continental.c_str(), Format::kHercules, "", "HeRCULES Continental"},
      {nested.c_str(), Format::kHercules, "", "HeRCULES Continental"},
      {aeva.c_str(), Format::kRaw, "aeva", "HeRCULES Aeva"},
      {"ars548/points/1700000000.000000000.pcd", Format::kPcd, "", "SNAIL-Radar ARS548"},
      {"eagleg7/enhanced/1700000000.000000000.pcd", Format::kPcd, "", "SNAIL-Radar Oculii"},
      {"single_chip/pointclouds/data/radar_pointcloud_0.bin", Format::kRaw, "coloradar5", "Colo"},
      {"aeva/1700000000000000.bin", Format::kRaw, "boreas_aeva40", "Boreas"},
      {"radar/000000.ply", Format::kPly, "", "1 files *.ply"},
      {"sprdr_00001.npy", Format::kNpy, "", "1 files *.npy"},
      {"scan1.csv", Format::kCsv, "", "1 files *.csv"},
  };
  for (const Case& c : cases) {
    const TempFolder folder;
    folder.Write(c.file, "whatever");
    const Found found = Detect(folder.path());
    EXPECT_EQ(found.format, c.format) << c.file << found.error;
    EXPECT_EQ(found.layout, c.layout) << c.file;
    EXPECT_THAT(found.reason, HasSubstr(c.reason));
  }
  const TempFolder folder;
  folder.Write("aeva/1700000000000000.bin", Floats({1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(Detect(folder.path()).layout, "boreas_aeva7");
  EXPECT_EQ(Detect(folder.path() / "aeva").layout, "boreas_aeva7");
  EXPECT_EQ(Detect(folder.path() / "aeva/").format, Format::kRaw);
  std::filesystem::remove_all(folder.path() / "aeva");
  folder.Write("point_clouds/00001.bin", Floats({1, 2, 3, 4}));
  EXPECT_EQ(Detect(folder.path()).format, Format::kAuto);
  folder.Write("ref_poses.txt", "0.0 0 0 0 0 0 0 1\n");
  EXPECT_EQ(Detect(folder.path()).layout, "dicp4");
}

TEST(DetectFormat, RosBagFoldersByTheirMetadata) {
  const TempFolder folder;
  folder.Write("metadata.yaml", "rosbag2_bagfile_information:\n  storage_identifier: mcap\n");
  EXPECT_EQ(Detect(folder.path()).format, Format::kMcap);
  folder.Write("metadata.yaml", "rosbag2_bagfile_information:\n  storage_identifier: sqlite3\n");
  EXPECT_EQ(Detect(folder.path()).format, Format::kRosbag2);
}

TEST(DetectFormat, RawFilesByWhatTheirNumbersProve) {
  const std::string vod = Floats({20, 1, 0, -7, -10, 0.2, 0});
  const std::string tj4d = Floats({3, 4, 12, -10, 13, 20, 1, 2});
  const TempFolder folder;
  folder.Write("training/velodyne/00549.bin", "");
  folder.Write("training/velodyne/00550.bin", vod + vod + vod + vod);
  EXPECT_EQ(Detect(folder.path()).layout, "vod7");
  EXPECT_THAT(Detect(folder.path()).reason, HasSubstr("time is a scan index in 4 of 4 records"));
  folder.Write("training/velodyne/00550.bin", tj4d + tj4d + tj4d);
  EXPECT_EQ(Detect(folder.path()).layout, "tj4d8");
  folder.Write("training/velodyne/00550.bin", Floats({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  const Found found = Detect(folder.path());
  EXPECT_EQ(found.format, Format::kAuto);
  EXPECT_THAT(found.error,
              AllOf(HasSubstr("set input.layout (00550.bin has 48 bytes, which fits xyz3,"),
                    HasSubstr("dicp4")));
  InputOptions options;
  options.layout = "xyz3";
  EXPECT_EQ(Detect(folder.path(), options).format, Format::kRaw);
}

TEST(DetectFormat, SeveralDatasetsInAFolderNeedAChoice) {
  const TempFolder folder;
  folder.Write("Radar/Continental/" + std::string(kStamp) + ".bin", "x");
  folder.Write("LiDAR/Aeva/" + std::string(kStamp) + ".bin", "x");
  EXPECT_THAT(Detect(folder.path()).error,
              AllOf(HasSubstr("holds HeRCULES Continental (Radar/Continental) and HeRCULES Aeva"),
                    HasSubstr("input.folder")));
}

TEST(DetectFormat, AFolderWithoutScansSaysWhatWasLookedFor) {
  const TempFolder folder;
  folder.Write("notes.txt", "nothing here");
  EXPECT_THAT(Detect(folder.path()).error,
              AllOf(HasSubstr(folder.string()),
                    HasSubstr("no scans found; looked for bags (*.bag"),
                    HasSubstr("RadarScenes")));
}

// A run's map would be a scan.
TEST(DetectFormat, ResultsAreNoDrive) {
  const TempFolder folder;
  for (const char* name : {"map.ply", "scans.csv", "run.json", "trajectory_tum.txt"}) {
    folder.Write(name, "something");
  }
  EXPECT_THAT(Detect(folder.path()).error, HasSubstr("but holds the results of a run"));
}

TEST(DetectFormat, LeavesASetFormatAlone) {
  InputOptions options;
  options.format = Format::kPcd;
  const Found found = Detect("/absent", options);
  EXPECT_EQ(found.format, Format::kPcd);
  EXPECT_EQ(found.reason, "as set");
}

// A bag of another sensor does not hide the scans beside it; one with point clouds does, and the
// reason names them.
TEST(DetectFormat, ScansBesideABag) {
  const TempFolder folder;
  for (const char* name : {"0.pcd", "1.pcd"}) folder.Write(name, "whatever");
  const testing::BagForm form = {"other.bag", BagFormat::kRosbag1};
  std::string error;
  const auto write = [&](const MessageTopic& topic) {
    const auto writer = testing::OpenWriter(folder.path() / form.name, form);
    const int number = writer->AddTopic(topic);
    ASSERT_TRUE(writer->Write(number, 1, "message", &error) && writer->Close(&error)) << error;
  };
  write({"/imu", "sensor_msgs/Imu", "ros1", {}});
  Found found = Detect(folder.path());
  EXPECT_EQ(found.format, Format::kPcd);
  EXPECT_THAT(found.reason, HasSubstr("it also holds 1 bag, other.bag, without point clouds"));
  write(testing::CloudTopic(form));
  found = Detect(folder.path());
  EXPECT_EQ(found.format, Format::kRosbag1);
  EXPECT_THAT(found.reason, HasSubstr("not read are the scans beside it (2 files *.pcd"));
}

}  // namespace
}  // namespace radive
