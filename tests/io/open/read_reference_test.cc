// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/read_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ReferenceFormat = ReferenceOptions::Format;

// Ground truth at `path`, detected.
Reference Read(const std::filesystem::path& path, int clip = 0) {
  std::string error;
  const auto reference = ReadReference(path, {}, clip, &error);
  EXPECT_TRUE(reference) << error;
  return reference.value_or(Reference());
}

std::string ErrorOf(const std::filesystem::path& path,
                    ReferenceFormat format = ReferenceFormat::kAuto) {
  ReferenceOptions options;
  options.format = format;
  std::string error;
  EXPECT_FALSE(ReadReference(path, options, 0, &error));
  return error;
}

class ReadReferenceOf : public ::testing::Test {
 protected:
  // The position of the last pose of a file of this name and text.
  Eigen::Vector3d LastPosition(const std::string& name, const std::string& text) {
    folder_.Write(name, text);
    const Reference reference = Read(folder_.path() / name);
    description_ = reference.description;
    has_stamps_ = reference.has_stamps;
    if (reference.poses.empty()) return Eigen::Vector3d::Zero();
    stamp_ns_ = reference.poses.back().stamp_ns;
    return reference.poses.back().T_world_body.translation;
  }

  const testing::TempFolder folder_;
  std::string description_;
  bool has_stamps_ = false;
  std::int64_t stamp_ns_ = -1;
};

TEST_F(ReadReferenceOf, FilesByTheNumberOfColumns) {
  EXPECT_EQ(LastPosition("a.txt", "1.5 1 2 3 0 0 0 1\n"), Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(description_, HasSubstr("1 poses (tum, "));
  EXPECT_TRUE(has_stamps_);
  // HeRCULES: integer nanoseconds.
  EXPECT_EQ(LastPosition("b.txt", "1723793044123456789 1 2 3 0 0 0 1\n"), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(stamp_ns_, 1723793044123456789);
  EXPECT_EQ(LastPosition("c.txt", "1 0 0 5 0 1 0 6 0 0 1 7\n"), Eigen::Vector3d(5, 6, 7));
  EXPECT_THAT(description_, HasSubstr("(kitti, "));
  EXPECT_FALSE(has_stamps_);
  EXPECT_EQ(LastPosition("d.csv", "#t\n1403715529107142912,1,2,3,1,0,0,0,9,9,9\n"),
            Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(description_, HasSubstr("(euroc, "));
  EXPECT_EQ(LastPosition("e.csv", "1.5,1,2,3,0,0,0,1,7,8,9\n"), Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(description_, HasSubstr("(table, "));
  // NTU4DRadLM, whose line of names may lack its #.
  EXPECT_EQ(LastPosition("gt_odom.txt", "timestamp tx ty tz qx qy qz qw\n1 1 2 3 0 0 0 1\n"),
            Eigen::Vector3d(1, 2, 3));
}

TEST_F(ReadReferenceOf, FoldersByWhatTheyHold) {
  const std::pair<const char*, const char*> cases[] = {
      {"ntu/gt_odom.txt", "# names\n0 1 2 3 0 0 0 1\n"},
      {"hercules/PR_GT/Continental_gt.txt", "1723793044123456789 1 2 3 0 0 0 1\n"},
      {"snail/ref_tls_T_xt32.csv", "1.5,1,2,3,0,0,0,1,4,5,6\n"},
      {"dicp/ref_poses.txt", "0 1 2 3 0 0 0 1\n"},
      {"boreas/applanix/aeva_poses.csv", "names\n1606417097528152,1,2,3,0,0,0,0,0,0\n"},
      {"kitti/gt_poses_kitti.txt", "1 0 0 1 0 1 0 2 0 0 1 3\n"},
      {"simulated/gt_tum.txt", "0 1 2 3 0 0 0 1\n"},
      {"scenes/radar1_scans.csv", "timestamp_odom,x,y,yaw\n0.5,1,2,0\n"},
  };
  for (const auto& [name, text] : cases) {
    folder_.Write(name, text);
    const std::string drive = std::string(name).substr(0, std::string(name).find('/'));
    const Reference reference = Read(folder_.path() / drive);
    ASSERT_EQ(reference.poses.size(), 1u) << name;
    EXPECT_EQ(reference.poses[0].T_world_body.translation.head<2>(), Eigen::Vector2d(1, 2)) << name;
  }
}

TEST_F(ReadReferenceOf, ColoRadarWithItsOwnFileOfStamps) {
  folder_.Write("groundtruth/groundtruth_poses.txt", "0 0 0 0 0 0 1\n1 2 3 0 0 0 1\n");
  folder_.Write("groundtruth/timestamps.txt", "1608000000.25\n1608000000.5\n");
  const Reference reference = Read(folder_.path());
  ASSERT_EQ(reference.poses.size(), 2u);
  EXPECT_EQ(reference.poses[1].stamp_ns, 1608000000500000000);
  EXPECT_EQ(reference.poses[1].T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  folder_.Write("groundtruth/timestamps.txt", "1608000000.25\n");
  EXPECT_THAT(ErrorOf(folder_.path()), HasSubstr("has 1 stamps, expected one for each of the 2"));
}

// The vehicle stands at (1, 2, 3) and has turned to its left; the sensor sits 2 m ahead.
TEST_F(ReadReferenceOf, DopplerIcpAsPosesOfTheSensor) {
  folder_.Write("ref_poses.txt", "0 1 2 3 0 0 0.70710678118654752 0.70710678118654752\n");
  folder_.Write("calibration.json",
                "{\"T_V_to_S\": {\"translation\": {\"x\": 2, \"y\": 0, \"z\": 0.5},"
                "\"quaternion\": {\"w\": 1, \"x\": 0, \"y\": 0, \"z\": 0}}}");
  const Reference reference = Read(folder_.path());
  ASSERT_EQ(reference.poses.size(), 1u);
  const Eigen::Vector3d position = reference.poses[0].T_world_body.translation;
  EXPECT_NEAR((position - Eigen::Vector3d(1, 4, 3.5)).norm(), 0.0, 1e-12);
  folder_.Write("calibration.json", "{\"T_V_to_S\": {\"translation\": {\"x\": 2}}}");
  EXPECT_THAT(ErrorOf(folder_.path()), HasSubstr("calibration.json: expected T_V_to_S"));
}

TEST_F(ReadReferenceOf, TheRadarsOfRadarScenesTogether) {
  folder_.Write("radar1_scans.csv", "timestamp_odom,x,y,yaw\n0.5,1,2,0\n1.5,3,2,0\n");
  folder_.Write("radar2_scans.csv", "timestamp_odom,x,y,yaw\n0.5,1,2,0\n1.0,2,2,0\n");
  const Reference reference = Read(folder_.path());
  ASSERT_EQ(reference.poses.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(reference.poses[i].T_world_body.translation.x(), 1.0 + static_cast<double>(i));
  }
}

TEST_F(ReadReferenceOf, SaysWhatWasLookedForAndWhatIsAmbiguous) {
  EXPECT_THAT(ErrorOf(folder_.path()),
              AllOf(HasSubstr("no ground truth found; looked for "),
                    HasSubstr("pose/*.json (View-of-Delft)")));
  EXPECT_THAT(ErrorOf(folder_.path() / "absent"), HasSubstr("absent: cannot be opened"));
  folder_.Write("PR_GT/Continental_gt.txt", "0 1 2 3 0 0 0 1\n");
  folder_.Write("PR_GT/Aeva_gt.txt", "0 1 2 3 0 0 0 1\n");
  EXPECT_THAT(ErrorOf(folder_.path()), HasSubstr("several files hold ground truth, name one"));
  folder_.Write("seven.txt", "1 2 3 4 5 6 7\n");
  EXPECT_THAT(ErrorOf(folder_.path() / "seven.txt"), HasSubstr("seven.txt:1: 7 columns, expected"));
  folder_.Write("radar1_scans.csv", "scan,x,y\n");
  EXPECT_THAT(ErrorOf(folder_.path() / "radar1_scans.csv"), HasSubstr("among them timestamp_odom"));
  folder_.Write("lfs.txt", testing::LfsPointer());
  EXPECT_THAT(ErrorOf(folder_.path() / "lfs.txt"), HasSubstr("Git-LFS pointer"));
  EXPECT_THAT(ErrorOf(folder_.path() / "seven.txt", ReferenceFormat::kTum),
              HasSubstr("expected 8 numbers"));
}

// Poses and stamps as its README counts them: 12 pairs without a gap.
TEST(RealReference, ClipOfRaFlow) {
  RADIVE_SKIP_WITHOUT("raflow-inhouse");
  const Reference reference = Read(testing::SharedData() / "raflow-inhouse" / "train");
  ASSERT_GE(reference.poses.size(), 12u);
  EXPECT_EQ(reference.poses[0].stamp_ns, 0);
  EXPECT_NEAR(reference.poses[1].stamp_s, 0.1, 1e-9);
  EXPECT_NEAR(reference.poses[0].T_world_body.rotation(2, 2), -1.0, 0.01) << "z is down";
}

// 1,606 scans of radar 2 and the others: the car drives 2.19 km.
TEST(RealReference, CarOfRadarScenes) {
  RADIVE_SKIP_WITHOUT("radarscenes/seq105");
  const Reference reference = Read(testing::SharedData() / "radarscenes" / "seq105");
  double path = 0.0;
  for (std::size_t i = 1; i < reference.poses.size(); ++i) {
    EXPECT_GT(reference.poses[i].stamp_ns, reference.poses[i - 1].stamp_ns);
    path += (reference.poses[i].T_world_body.translation -
             reference.poses[i - 1].T_world_body.translation)
                .norm();
  }
  EXPECT_NEAR(path, 2190.0, 10.0);
}

}  // namespace
}  // namespace radive
