// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/trajectory_io.h"

#include <fstream>
#include <system_error>
#include <vector>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/check_poses.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/util/number_text.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

struct LineForm {
  std::size_t num_values;
  bool more_allowed;
  const char* names;
};

LineForm FormOf(TrajectoryFormat format) {
  switch (format) {
    case TrajectoryFormat::kKitti:
      return {12, false, "r00 r01 r02 x r10 r11 r12 y r20 r21 r22 z"};
    case TrajectoryFormat::kEuroc:
      return {8, true, "t_ns x y z qw qx qy qz"};
    case TrajectoryFormat::kTum:
      break;
  }
  return {8, false, "t x y z qx qy qz qw"};
}

// Sets the stamp from its text; false when that is no stamp.
bool ReadStamp(std::string_view text, double value, TrajectoryFormat format, RecordedPose* pose) {
  const bool nanoseconds = format == TrajectoryFormat::kEuroc || LooksLikeNanoseconds(text);
  const std::optional<std::int64_t> stamp_ns = ParseStamp(text, nanoseconds ? -9 : 0);
  if (!stamp_ns) return false;
  pose->stamp_ns = *stamp_ns;
  pose->stamp_s = nanoseconds ? value / 1e9 : value;
  return true;
}

// One line to one pose. On failure `problem` says what was expected.
bool ParsePose(std::string_view line,
               TrajectoryFormat format,
               RecordedPose* pose,
               std::string* problem) {
  if (HasDecimalCommas(line, problem)) return false;
  const LineForm form = FormOf(format);
  const std::vector<std::string_view> words = SplitColumns(line);
  const bool enough = words.size() >= form.num_values;
  if (!enough || (words.size() > form.num_values && !form.more_allowed)) {
    *problem = "expected " + std::to_string(form.num_values) + " numbers '" + form.names +
               "', found " + std::to_string(words.size());
    return false;
  }

  std::vector<double> v(form.num_values);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::optional<double> value = ParseFinite(words[i]);
    if (!value) {
      *problem = "expected a finite number in column " + std::to_string(i + 1) + " of '" +
                 form.names + "', found '" + std::string(words[i]) + "'";
      return false;
    }
    v[i] = *value;
  }

  if (format == TrajectoryFormat::kKitti) {
    pose->T_world_body.rotation << v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10];
    pose->T_world_body.translation << v[3], v[7], v[11];
    return CheckPose(*pose, problem);
  }
  if (!ReadStamp(words[0], v[0], format, pose)) {
    *problem = "expected a stamp within 146 years of zero, found '" + std::string(words[0]) + "'";
    return false;
  }
  pose->T_world_body.translation << v[1], v[2], v[3];
  const bool is_scalar_first = format == TrajectoryFormat::kEuroc;
  if (is_scalar_first) {
    SetRotation(v[4], v[5], v[6], v[7], pose);
  } else {
    SetRotation(v[7], v[4], v[5], v[6], pose);
  }
  return CheckPose(*pose, problem);
}

bool WriteLines(const std::filesystem::path& file,
                const Trajectory& trajectory,
                std::string (*line_of)(const StampedPose&),
                std::string* error) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream stream(part, std::ios::binary);
  for (const StampedPose& pose : trajectory) stream << line_of(pose) << '\n';
  stream.close();
  if (!stream) {
    *error = part.string() + ": cannot be written";
    return false;
  }
  std::error_code code;
  std::filesystem::rename(part, file, code);
  if (code) *error = file.string() + ": cannot be written: " + SystemMessage(code);
  return !code;
}

}  // namespace

std::optional<RecordedTrajectory> ParseTrajectory(std::string_view text,
                                                  TrajectoryFormat format,
                                                  const std::string& place,
                                                  std::string* error) {
  RecordedTrajectory trajectory;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    const std::size_t first = line.find_first_not_of(kColumnSeparators);
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (trajectory.empty() && HoldsNamesOnly(line)) continue;
    RecordedPose pose;
    std::string problem;
    if (!ParsePose(line, format, &pose, &problem)) {
      *error = place + ":" + std::to_string(lines.number()) + ": " + problem;
      return std::nullopt;
    }
    trajectory.push_back(pose);
  }
  if (trajectory.empty()) {
    *error = place + ": holds no poses; expected lines '" + FormOf(format).names + "'";
    return std::nullopt;
  }
  return trajectory;
}

std::optional<RecordedTrajectory> ReadTrajectory(const std::filesystem::path& file,
                                                 TrajectoryFormat format,
                                                 std::string* error) {
  std::string text;
  if (!ReadWholeFile(file, &text, error)) return std::nullopt;
  return ParseTrajectory(text, format, file.string(), error);
}

std::string TumLine(const StampedPose& pose) {
  const Eigen::Vector3d& p = pose.T_world_body.translation;
  const Eigen::Quaterniond& q = pose.T_world_body.rotation;
  std::string line = FormatStamp(pose.stamp_ns);
  for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
    line += FormatText(" %.9f", value);
  }
  return line;
}

std::string KittiLine(const StampedPose& pose) {
  Eigen::Matrix<double, 3, 4> rows;
  rows << pose.T_world_body.RotationMatrix(), pose.T_world_body.translation;
  std::string line;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      line += FormatText("%s%.9f", line.empty() ? "" : " ", rows(row, column));
    }
  }
  return line;
}

bool WriteTumTrajectory(const std::filesystem::path& file,
                        const Trajectory& trajectory,
                        std::string* error) {
  return WriteLines(file, trajectory, &TumLine, error);
}

}  // namespace radive
