// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "radive/io/bags/open_message_source.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/bytes/byte_order.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

// Header with stamp SECONDS.5 and frame "map".
std::string Header(std::uint32_t seconds, bool is_ros1) {
  return (is_ros1 ? LittleEndian<std::uint32_t>(7) : std::string("\0\1\0\0", 4)) +
         LittleEndian<std::uint32_t>(seconds) + LittleEndian<std::uint32_t>(500000000) +
         (is_ros1 ? LittleEndian<std::uint32_t>(3) + "map"
                  : LittleEndian<std::uint32_t>(4) + std::string("map\0", 4));
}

std::string Doubles(std::initializer_list<double> values) {
  std::string bytes;
  for (const double value : values) bytes += LittleEndian(value);
  return bytes;
}

MessageTopic Topic(const std::string& type, const std::string& encoding = "ros1") {
  return {"/truth", type, encoding, {}};
}

TEST(BagTrajectory, ReadsPosesOfBothGenerations) {
  // Half a turn about z.
  const std::string numbers = Doubles({1, 2, 3, 0, 0, 1, 0});
  const std::pair<MessageTopic, std::string> cases[] = {
      {Topic("geometry_msgs/PoseStamped"), Header(9, true) + numbers},
      // In CDR the body of the header is 16 bytes long, so the doubles need no padding.
      {Topic("geometry_msgs/msg/PoseWithCovarianceStamped", "cdr"), Header(9, false) + numbers},
      {Topic("nav_msgs/Odometry"),
       Header(9, true) + LittleEndian<std::uint32_t>(4) + "base" + numbers},
      // The child frame takes 9 bytes: 7 of padding up to the doubles.
      {Topic("nav_msgs/msg/Odometry", "cdr"),
       Header(9, false) + LittleEndian<std::uint32_t>(5) + std::string("base\0", 5) +
           std::string(7, 'x') + numbers},
      {Topic("geometry_msgs/TransformStamped"),
       Header(9, true) + LittleEndian<std::uint32_t>(4) + "base" + numbers},
  };
  for (const auto& [topic, payload] : cases) {
    PoseMessage message;
    ASSERT_TRUE(ReadPoseMessage(payload, topic, &message)) << topic.type;
    EXPECT_EQ(message.pose.stamp_ns, 9500000000) << topic.type;
    EXPECT_EQ(message.pose.stamp_s, 9.5);
    EXPECT_EQ(message.pose.T_world_body.translation, Eigen::Vector3d(1, 2, 3)) << topic.type;
    EXPECT_NEAR(message.pose.T_world_body.rotation(0, 0), -1.0, 1e-15) << topic.type;
    EXPECT_FALSE(ReadPoseMessage(payload.substr(0, payload.size() - 1), topic, &message));
  }
  PoseMessage message;
  EXPECT_FALSE(ReadPoseMessage(Header(9, true) + Doubles({NAN, 0, 0, 0, 0, 0, 1}),
                               Topic("geometry_msgs/PoseStamped"),
                               &message));
}

std::string Fix(double latitude, double longitude, double altitude, int status = 0) {
  return Header(1, true) + static_cast<char>(status) + std::string(2, '\0') +
         Doubles({latitude, longitude, altitude});
}

class FixesInABag : public ::testing::Test {
 protected:
  void Write(const std::string& type, const std::vector<std::string>& payloads) {
    std::string error;
    auto writer = Ros1BagWriter::Create(
        folder_.path() / "a.bag", {Compression::kNone, /*index=*/true, 1000}, &error);
    ASSERT_NE(writer, nullptr) << error;
    const int topic = writer->AddTopic(Topic(type));
    for (std::size_t i = 0; i < payloads.size(); ++i) {
      EXPECT_TRUE(writer->Write(topic, static_cast<std::int64_t>(i), payloads[i], &error)) << error;
    }
    ASSERT_TRUE(writer->Close(&error)) << error;
  }
  std::optional<BagTrajectory> Read(const std::string& topic, std::string* error) {
    auto bag =
        OpenMessageSource(folder_.path() / "a.bag", BagFormat::kRosbag1, MessageLimits(), error);
    EXPECT_NE(bag, nullptr) << *error;
    return ReadBagTrajectory(std::move(bag), "a.bag", topic, error);
  }
  const testing::TempFolder folder_;
};

// Payloads whose header says 0 s; the bag recorded them at 0, 1 and 2 ns.
TEST_F(FixesInABag, PosesWithoutStampsHaveTheTimesOfRecording) {
  const auto pose = [](std::uint32_t nanoseconds, double x) {
    return std::string(8, '\0') + LittleEndian(nanoseconds) + LittleEndian<std::uint32_t>(3) +
           "map" + Doubles({x, 0, 0, 0, 0, 0, 1});
  };
  Write("geometry_msgs/PoseStamped", {pose(0, 5), pose(0, 6), pose(0, 7)});
  std::string error;
  const auto trajectory = Read("", &error);
  ASSERT_TRUE(trajectory) << error;
  ASSERT_EQ(trajectory->poses.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(trajectory->poses[i].stamp_ns, static_cast<std::int64_t>(i));
    EXPECT_EQ(trajectory->poses[i].T_world_body.translation.x(), 5.0 + static_cast<double>(i));
  }
  EXPECT_THAT(trajectory->description, HasSubstr("by the times of recording, for the headers"));
  // Stamps that are there stay.
  Write("geometry_msgs/PoseStamped", {pose(500, 5), pose(700, 6), pose(900, 7)});
  const auto stamped = Read("", &error);
  ASSERT_TRUE(stamped) << error;
  EXPECT_EQ(stamped->poses[2].stamp_ns, 900);
  EXPECT_THAT(stamped->description, ::testing::Not(HasSubstr("times of recording")));
}

// At the equator a degree of latitude is 110,574.3 m of meridian, and one of longitude 111,319.5 m;
// the places are taken as points of a plane, the chord of which is a little shorter.
TEST_F(FixesInABag, BecomeMetresEastNorthUpOfTheFirst) {
  Write("sensor_msgs/NavSatFix",
        {Fix(NAN, 0, 0, -1),
         Fix(0, 10, 100),
         Fix(0, 10.001, 100),
         Fix(0.001, 10, 100),
         Fix(0, 10, 150, -1),
         Fix(0, 10, 150)});
  std::string error;
  const auto trajectory = Read("", &error);
  ASSERT_TRUE(trajectory) << error;
  EXPECT_FALSE(trajectory->has_rotations);
  ASSERT_EQ(trajectory->poses.size(), 4u) << "two have no fix";
  const auto position = [&](std::size_t i) {
    return trajectory->poses[i].T_world_body.translation;
  };
  EXPECT_NEAR(position(0).norm(), 0.0, 1e-9);
  EXPECT_NEAR((position(1) - Eigen::Vector3d(111.3212, 0, 0)).norm(), 0.0, 2e-3);
  EXPECT_NEAR((position(2) - Eigen::Vector3d(0, 110.5760, 0)).norm(), 0.0, 2e-3);
  EXPECT_NEAR((position(3) - Eigen::Vector3d(0, 0, 50)).norm(), 0.0, 1e-6);
}

TEST_F(FixesInABag, SaysWhatIsMissing) {
  Write("sensor_msgs/NavSatFix", {Fix(0, 10, 100).substr(0, 30)});
  std::string error;
  EXPECT_FALSE(Read("", &error));
  EXPECT_THAT(error, HasSubstr("a.bag: message 1 of /truth is damaged"));
  EXPECT_FALSE(Read("/other", &error));
  EXPECT_THAT(error, HasSubstr("no poses on topic '/other'; it has: /truth (sensor_msgs/NavSat"));
  Write("sensor_msgs/Imu", {"x"});
  EXPECT_FALSE(Read("", &error));
  EXPECT_THAT(error, HasSubstr("has no poses, expected a topic of type Odometry"));
}

}  // namespace
}  // namespace radive
