// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "radive/io/bags/message_source.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// Messages that say where something is, of ROS 1 and ROS 2.
enum class PoseType {
  kNone,
  kPose,         // geometry_msgs PoseStamped and PoseWithCovarianceStamped
  kPoseOfChild,  // nav_msgs Odometry: the pose of its child frame
  kTransformStamped,
  kNavSatFix  // sensor_msgs NavSatFix: latitude, longitude, altitude; no rotation
};

PoseType PoseTypeOf(const MessageTopic& topic);

// A message of such a topic. Positions of NavSatFix are latitude and longitude [rad] and altitude
// above the ellipsoid [m]; `has_fix` says whether the receiver had any. False when the message is
// cut off, or a number in it is not finite or no rotation.
struct PoseMessage {
  RecordedPose pose;
  bool has_fix = true;
};
bool ReadPoseMessage(std::string_view payload, const MessageTopic& topic, PoseMessage* message);

// Poses of a topic of a bag, in the order of recording.
struct BagTrajectory {
  RecordedTrajectory poses;
  bool has_rotations = true;
  std::string description;  // "ROS 1 bag FILE, topic /fix (sensor_msgs/NavSatFix)"
};

// Reads the poses on `topic`, or on the only topic of such messages when it is empty; stamps are
// those of the headers. Fixes become positions east, north and up of the first one [m]. Messages
// without a fix are left out. Nothing, with place and expectation in `error`, when the bag has no
// such topic, or several, or a message cannot be read.
std::optional<BagTrajectory> ReadBagTrajectory(std::unique_ptr<MessageSource> bag,
                                               const std::string& place,
                                               const std::string& topic,
                                               std::string* error);

}  // namespace radive
