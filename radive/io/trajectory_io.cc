// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectory_io.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include "radive/io/stamp_text.h"

namespace radive {
namespace {

constexpr std::string_view kSeparators = " \t,\r";

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

std::vector<std::string_view> SplitLine(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kSeparators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSeparators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSeparators, end);
  }
  return words;
}

// The nearest double, as Python's float() reads it; independent of the locale.
std::optional<double> ParseDouble(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [rest, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc() && rest == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

// Rotation matrix of a quaternion of any length; identity for (almost) zero ones, as evo has it.
Eigen::Matrix3d RotationMatrix(double w, double x, double y, double z) {
  const Eigen::Quaterniond q(w, x, y, z);
  if (q.squaredNorm() < 4.0 * std::numeric_limits<double>::epsilon()) {
    return Eigen::Matrix3d::Identity();
  }
  return q.normalized().toRotationMatrix();
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
  const LineForm form = FormOf(format);
  const std::vector<std::string_view> words = SplitLine(line);
  const bool enough = words.size() >= form.num_values;
  if (!enough || (words.size() > form.num_values && !form.more_allowed)) {
    *problem = "expected " + std::to_string(form.num_values) + " numbers '" + form.names +
               "', found " + std::to_string(words.size());
    return false;
  }

  std::vector<double> v(form.num_values);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::optional<double> value = ParseDouble(words[i]);
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
    return true;
  }
  if (!ReadStamp(words[0], v[0], format, pose)) {
    *problem = "expected a stamp within 292 years of zero, found '" + std::string(words[0]) + "'";
    return false;
  }
  pose->T_world_body.translation << v[1], v[2], v[3];
  pose->T_world_body.rotation = format == TrajectoryFormat::kEuroc
                                    ? RotationMatrix(v[4], v[5], v[6], v[7])
                                    : RotationMatrix(v[7], v[4], v[5], v[6]);
  return true;
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
  if (code) *error = file.string() + ": cannot be written: " + code.message();
  return !code;
}

}  // namespace

std::optional<RecordedTrajectory> ReadTrajectory(const std::filesystem::path& file,
                                                 TrajectoryFormat format,
                                                 std::string* error) {
  std::error_code code;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, code)) {
    *error = file.string() + ": cannot be opened; expected a trajectory file";
    return std::nullopt;
  }
  RecordedTrajectory trajectory;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::string_view text = line;
    if (number == 1 && text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(kSeparators);
    if (first == std::string_view::npos || text[first] == '#') continue;
    RecordedPose pose;
    std::string problem;
    if (!ParsePose(text, format, &pose, &problem)) {
      *error = file.string() + ":" + std::to_string(number) + ": " + problem;
      return std::nullopt;
    }
    trajectory.push_back(pose);
  }
  if (stream.bad()) {
    *error = file.string() + ": reading failed";
    return std::nullopt;
  }
  if (trajectory.empty()) {
    *error = file.string() + ": holds no poses; expected lines '" + FormOf(format).names + "'";
    return std::nullopt;
  }
  return trajectory;
}

std::string TumLine(const StampedPose& pose) {
  const Eigen::Vector3d& p = pose.T_world_body.translation;
  const Eigen::Quaterniond& q = pose.T_world_body.rotation;
  std::string line = FormatStamp(pose.stamp_ns);
  for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
    char text[400];  // the longest double takes 320 characters
    std::snprintf(text, sizeof(text), " %.9f", value);
    line += text;
  }
  return line;
}

std::string KittiLine(const StampedPose& pose) {
  Eigen::Matrix<double, 3, 4> rows;
  rows << pose.T_world_body.RotationMatrix(), pose.T_world_body.translation;
  std::string line;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      char text[400];
      std::snprintf(text, sizeof(text), "%s%.9f", line.empty() ? "" : " ", rows(row, column));
      line += text;
    }
  }
  return line;
}

bool WriteTumTrajectory(const std::filesystem::path& file,
                        const Trajectory& trajectory,
                        std::string* error) {
  return WriteLines(file, trajectory, &TumLine, error);
}

bool WriteKittiTrajectory(const std::filesystem::path& file,
                          const Trajectory& trajectory,
                          std::string* error) {
  return WriteLines(file, trajectory, &KittiLine, error);
}

}  // namespace radive
