// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/trajectories/pose_names.h"
#include "radive/util/text.h"

namespace radive {
namespace {

// applanix/*_poses.csv: t [us], x y z in ENU, three velocities, roll, pitch, yaw and more, under
// names that ColumnsByName() does not know.
std::optional<PoseColumns> BoreasTruthColumns(std::string_view /*names*/) {
  PoseColumns columns;
  columns.has_names = true;
  columns.stamp = 0;
  columns.stamp_exponent = -6;
  columns.position = {1, 2, 3};
  columns.angles = {7, 8, 9};
  columns.angles_are_passive = true;
  return columns;
}

// Whether the names in the first line tell the columns of another table.
bool NamesTell(const std::filesystem::path& file) {
  std::string text, ignored;
  if (!ReadWholeFile(file, &text, &ignored)) return false;
  TextLines lines(text);
  std::string_view first;
  return lines.Next(&first) && ColumnsByName(SplitNames(first)).has_value();
}

bool IsBoreasTruth(const std::filesystem::path& file) {
  return EndsWith(file.filename().string(), "_poses.csv") && !NamesTell(file);
}

}  // namespace

Dataset BoreasDataset() {
  Dataset dataset;
  dataset.name = "Boreas";
  DatasetSensor& aeva = dataset.sensors.emplace_back();
  aeva.name = "Boreas Aeva";
  aeva.folders = {"aeva"};
  aeva.layouts = {"boreas_aeva40", "boreas_aeva7"};
  dataset.truth_files = {{"applanix/aeva_poses.csv", ReferenceOptions::Format::kBoreas}};
  dataset.truth.format = ReferenceOptions::Format::kBoreas;
  dataset.truth.is_file = IsBoreasTruth;
  dataset.truth.columns = BoreasTruthColumns;
  return dataset;
}

}  // namespace radive
