// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_trajectory.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "radive/io/bags/ros_message_reader.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/pose_text.h"

namespace radive {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

// WGS84.
constexpr double kSemiMajorAxis = 6378137.0;  // [m]
constexpr double kFlattening = 1.0 / 298.257223563;

// "sensor_msgs/msg/NavSatFix" and "sensor_msgs/NavSatFix" are the same.
std::string WithoutMsg(const std::string& type) {
  const std::size_t middle = type.find("/msg/");
  return middle == std::string::npos ? type : type.substr(0, middle) + type.substr(middle + 4);
}

Eigen::Vector3d EarthCentred(const Eigen::Vector3d& latitude_longitude_altitude) {
  const double sin_lat = std::sin(latitude_longitude_altitude[0]);
  const double cos_lat = std::cos(latitude_longitude_altitude[0]);
  const double eccentricity = kFlattening * (2.0 - kFlattening);
  const double normal = kSemiMajorAxis / std::sqrt(1.0 - eccentricity * sin_lat * sin_lat);
  const double altitude = latitude_longitude_altitude[2];
  return {(normal + altitude) * cos_lat * std::cos(latitude_longitude_altitude[1]),
          (normal + altitude) * cos_lat * std::sin(latitude_longitude_altitude[1]),
          (normal * (1.0 - eccentricity) + altitude) * sin_lat};
}

// Rows east, north, up at a place on the earth.
Eigen::Matrix3d EastNorthUp(const Eigen::Vector3d& latitude_longitude_altitude) {
  const double sin_lat = std::sin(latitude_longitude_altitude[0]);
  const double cos_lat = std::cos(latitude_longitude_altitude[0]);
  const double sin_lon = std::sin(latitude_longitude_altitude[1]);
  const double cos_lon = std::cos(latitude_longitude_altitude[1]);
  Eigen::Matrix3d rows;
  rows << -sin_lon, cos_lon, 0.0,                       //
      -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat,  //
      cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;
  return rows;
}

// Turns latitude, longitude and altitude into metres from the first place.
void ToLocalMetres(RecordedTrajectory* poses) {
  if (poses->empty()) return;
  const Eigen::Vector3d first = poses->front().T_world_body.translation;
  const Eigen::Vector3d origin = EarthCentred(first);
  const Eigen::Matrix3d axes = EastNorthUp(first);
  for (RecordedPose& pose : *poses) {
    Eigen::Vector3d& position = pose.T_world_body.translation;
    position = axes * (EarthCentred(position) - origin);
  }
}

// Stamps that are all the same are none; a single one is believed unless it is zero.
bool HeadersHaveNoStamps(const RecordedTrajectory& poses) {
  if (poses.empty() || (poses.size() == 1 && poses.front().stamp_ns != 0)) return false;
  return std::all_of(poses.begin(), poses.end(), [&](const RecordedPose& pose) {
    return pose.stamp_ns == poses.front().stamp_ns;
  });
}

bool ReadFix(RosMessageReader* reader, PoseMessage* message) {
  const auto status = static_cast<std::int8_t>(reader->U8());
  reader->U16();  // service
  const double latitude = reader->F64();
  const double longitude = reader->F64();
  message->has_fix = status >= 0 && std::isfinite(latitude) && std::isfinite(longitude);
  double altitude = reader->F64();
  if (!std::isfinite(altitude)) altitude = 0.0;  // as the message defines it: unknown
  message->pose.T_world_body.translation << latitude * kRadiansPerDegree,
      longitude * kRadiansPerDegree, altitude;
  return std::abs(latitude) <= 90.0 || !message->has_fix;
}

std::optional<int> ChoosePoseTopic(const std::vector<MessageTopic>& topics,
                                   const std::string& wanted,
                                   std::string* error) {
  std::string names;
  std::vector<int> found;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (PoseTypeOf(topics[i]) == PoseType::kNone) continue;
    names += (names.empty() ? "" : ", ") + topics[i].name + " (" + topics[i].type + ")";
    if (wanted.empty() || topics[i].name == wanted) found.push_back(static_cast<int>(i));
  }
  if (found.size() == 1) return found.front();
  const std::string expected =
      "Odometry, PoseStamped, PoseWithCovarianceStamped, TransformStamped or NavSatFix";
  if (names.empty()) {
    *error = "has no poses, expected a topic of type " + expected;
  } else if (found.empty()) {
    *error = "has no poses on topic " + Quoted(wanted) + "; it has: " + names;
  } else {
    *error = "has several topics with poses, say with reference.topic which one: " + names;
  }
  return std::nullopt;
}

}  // namespace

PoseType PoseTypeOf(const MessageTopic& topic) {
  const std::string type = WithoutMsg(topic.type);
  if (type == "geometry_msgs/PoseStamped" || type == "geometry_msgs/PoseWithCovarianceStamped") {
    return PoseType::kPose;
  }
  if (type == "nav_msgs/Odometry") return PoseType::kPoseOfChild;
  if (type == "geometry_msgs/TransformStamped") return PoseType::kTransformStamped;
  if (type == "sensor_msgs/NavSatFix") return PoseType::kNavSatFix;
  return PoseType::kNone;
}

bool ReadPoseMessage(std::string_view payload, const MessageTopic& topic, PoseMessage* message) {
  *message = PoseMessage();
  const PoseType type = PoseTypeOf(topic);
  RosMessageReader reader(payload,
                          topic.encoding == "ros1" ? RosMessageReader::Encoding::kRos1
                                                   : RosMessageReader::Encoding::kCdr);
  RecordedPose& pose = message->pose;
  pose.stamp_ns = reader.ReadHeader().stamp_ns;
  pose.stamp_s = StampSeconds(pose.stamp_ns);
  if (type == PoseType::kNavSatFix) return ReadFix(&reader, message) && !reader.failed();
  if (type != PoseType::kPose) reader.String();  // the child frame
  for (int i = 0; i < 3; ++i) pose.T_world_body.translation[i] = reader.F64();
  std::array<double, 4> q;  // x y z w
  for (double& value : q) value = reader.F64();
  const double squared_length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (reader.failed() || !pose.T_world_body.translation.allFinite() ||
      !std::isfinite(squared_length)) {
    return false;
  }
  SetRotation(q[3], q[0], q[1], q[2], &pose);
  return true;
}

std::optional<BagTrajectory> ReadBagTrajectory(std::unique_ptr<MessageSource> bag,
                                               const std::string& place,
                                               const std::string& wanted_topic,
                                               std::string* error) {
  std::string reason;
  const std::optional<int> chosen = ChoosePoseTopic(bag->topics(), wanted_topic, &reason);
  if (!chosen) {
    *error = place + ": " + reason;
    return std::nullopt;
  }
  const MessageTopic topic = bag->topics()[static_cast<std::size_t>(*chosen)];
  bag->Select({*chosen});
  BagTrajectory trajectory;
  trajectory.has_rotations = PoseTypeOf(topic) != PoseType::kNavSatFix;
  trajectory.description = bag->Description() + ", topic " + topic.name + " (" + topic.type + ")";
  std::vector<std::int64_t> record_ns;  // of the poses
  MessageSource::Status status;
  Message message;
  for (int number = 1; (status = bag->Next(&message)) == MessageSource::Status::kMessage;
       ++number) {
    PoseMessage pose;
    if (!ReadPoseMessage(message.payload, topic, &pose)) {
      *error = place + ": message " + std::to_string(number) + " of " + topic.name +
               " is damaged, or holds no " + (trajectory.has_rotations ? "pose" : "place");
      return std::nullopt;
    }
    if (!pose.has_fix) continue;
    trajectory.poses.push_back(pose.pose);
    record_ns.push_back(message.record_ns);
  }
  if (status == MessageSource::Status::kError) {
    *error = bag->error();
    return std::nullopt;
  }
  if (HeadersHaveNoStamps(trajectory.poses)) {
    for (std::size_t i = 0; i < record_ns.size(); ++i) {
      trajectory.poses[i].stamp_ns = record_ns[i];
      trajectory.poses[i].stamp_s = StampSeconds(record_ns[i]);
    }
    trajectory.description += ", by the times of recording, for the headers have no stamps";
  }
  if (!trajectory.has_rotations) ToLocalMetres(&trajectory.poses);
  if (!trajectory.poses.empty()) return trajectory;
  *error = place + ": topic " + topic.name + " holds no poses";
  return std::nullopt;
}

}  // namespace radive
