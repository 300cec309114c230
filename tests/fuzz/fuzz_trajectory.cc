// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "radive/io/datasets/dataset.h"
#include "radive/io/trajectories/find_pose_columns.h"
#include "radive/io/trajectories/pose_table.h"
#include "radive/io/trajectories/trajectory_io.h"

namespace {

using radive::RecordedTrajectory;

// A trajectory has poses, each of which takes some bytes; no trajectory comes with a reason.
void Check(const std::optional<RecordedTrajectory>& poses,
           std::size_t size,
           const std::string& error) {
  if (!poses && error.empty()) std::abort();
  if (poses && (poses->empty() || poses->size() > size)) std::abort();
  if (!poses) return;
  for (const radive::RecordedPose& pose : *poses) {
    if (!pose.T_world_body.translation.allFinite()) std::abort();
  }
}

// Of the datasets that have a table of their own, one after the other, or found out.
std::optional<radive::PoseColumns> Columns(int kind, std::string_view text, std::string* error) {
  for (const radive::Dataset& dataset : radive::Datasets()) {
    if (dataset.truth.columns == nullptr || kind-- > 0) continue;
    *error = "no such columns";
    return dataset.truth.columns(text.substr(0, text.find('\n')));
  }
  return radive::FindPoseColumns(text, "fuzz", error);
}

}  // namespace

// The first byte says which format the others have.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const int kind = data[0] % 7;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::string error;
  if (kind < 3) {
    const auto format = static_cast<radive::TrajectoryFormat>(kind);
    Check(radive::ParseTrajectory(text, format, "fuzz", &error), size, error);
    return 0;
  }
  const std::optional<radive::PoseColumns> columns = Columns(kind - 3, text, &error);
  std::optional<RecordedTrajectory> poses;
  RecordedTrajectory read;
  if (columns && radive::ParsePoseTable(text, *columns, "fuzz", &read, &error)) poses = read;
  Check(poses, size, error);
  return 0;
}
