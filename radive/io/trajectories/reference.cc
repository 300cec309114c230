// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/reference.h"

#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/trajectories/find_pose_columns.h"

namespace radive {

namespace fs = std::filesystem;

bool SetPoses(std::optional<RecordedTrajectory> poses, bool has_stamps, Reference* reference) {
  if (!poses) return false;
  reference->poses = *std::move(poses);
  reference->has_stamps = has_stamps;
  return true;
}

bool ReadReferenceText(const fs::path& file,
                       TrajectoryFormat format,
                       Reference* reference,
                       std::string* error) {
  return SetPoses(
      ReadTrajectory(file, format, error), format != TrajectoryFormat::kKitti, reference);
}

bool ReadReferenceTable(const fs::path& file,
                        const std::optional<PoseColumns>& known,
                        Reference* reference,
                        std::string* error) {
  std::string text;
  if (!ReadWholeFile(file, &text, error)) return false;
  const std::optional<PoseColumns> columns =
      known ? known : FindPoseColumns(text, file.string(), error);
  if (!columns) return false;
  reference->has_stamps = columns->stamp >= 0;
  return ParsePoseTable(text, *columns, file.string(), &reference->poses, error);
}

}  // namespace radive
