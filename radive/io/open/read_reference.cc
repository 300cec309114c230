// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/read_reference.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "radive/io/bags/bag_trajectory.h"
#include "radive/io/bags/open_message_source.h"
#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/trajectories/check_poses.h"
#include "radive/io/trajectories/find_pose_columns.h"
#include "radive/io/trajectories/pose_names.h"
#include "radive/io/trajectories/pose_table.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/io/trajectories/trajectory_io.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
using ReferenceFormat = ReferenceOptions::Format;

const std::string& NameOf(ReferenceFormat format) {
  return ReferenceFormatNames()[static_cast<std::size_t>(format)];
}

// A file or folder, and how it is to be read.
struct Found {
  fs::path path;
  ReferenceFormat format = ReferenceFormat::kAuto;
};

bool IsBag(const fs::path& path) {
  return BagFormatOfName(path.filename().string()).has_value() ||
         path.filename() == "metadata.yaml";
}

// The form of the bags in `folder`, if there are any.
std::optional<BagFormat> FormOfBags(const fs::path& folder) {
  for (const BagFormat format : {BagFormat::kRosbag1, BagFormat::kRosbag2, BagFormat::kMcap}) {
    std::vector<fs::path> files;
    std::string ignored;
    if (ListBagFiles(folder, format, &files, &ignored) && !files.empty()) return format;
  }
  return std::nullopt;
}

bool AreTumColumns(const PoseColumns& columns) {
  return columns.stamp == 0 && !columns.has_stamp_unit &&
         columns.position == std::array<int, 3>{1, 2, 3} &&
         columns.quaternion == std::array<int, 4>{4, 5, 6, 7};
}

// EuRoC's tables say in their names what the rule of the format says as well.
bool AreEurocColumns(const PoseColumns& columns, bool has_names) {
  return !has_names || (columns.stamp == 0 && columns.position == std::array<int, 3>{1, 2, 3} &&
                        columns.quaternion == std::array<int, 4>{5, 6, 7, 4});
}

// By the names of the columns or, without them, by their numbers. Files of the common forms are
// read as such: they allow no other columns.
std::optional<ReferenceFormat> FormatOfColumns(const fs::path& file, std::string* error) {
  std::string text;
  if (!ReadWholeFile(file, &text, error)) return std::nullopt;
  TextLines lines(text);
  std::vector<std::string_view> words;
  std::string_view line;
  bool has_names = false;
  while (words.empty() && lines.Next(&line)) {
    const std::string_view content = TrimBlanks(line);
    if (content.empty()) continue;
    const bool is_comment = content.front() == '#' || content.front() == '%';
    if (is_comment || HoldsNamesOnly(line)) {
      has_names = has_names || ColumnsByName(SplitNames(content)).has_value() || !is_comment;
      continue;
    }
    words = SplitColumns(line);
  }
  // Twelve numbers without names are KITTI's rows, whatever four of them look like: that they are
  // no rotations is for the reader to say.
  const bool has_blanks_only = line.find_first_of(",;") == line.npos;
  if (words.size() == 12 && has_blanks_only && !has_names) return ReferenceFormat::kKitti;
  std::string reason;
  const std::optional<PoseColumns> columns = FindPoseColumns(text, file.string(), &reason);
  const bool has_euroc_form = words.size() >= 8 && words.size() != 12 &&
                              line.find(',') != line.npos && LooksLikeNanoseconds(words[0]);
  const bool is_matrix = columns && columns->matrix[0] >= 0;
  if (has_euroc_form && !is_matrix && AreEurocColumns(columns.value_or(PoseColumns()), has_names)) {
    return ReferenceFormat::kEuroc;
  }
  if (!columns) {
    *error = reason;
    return std::nullopt;
  }
  const bool is_plain = columns->delimiter == '\0';
  if (is_plain && words.size() == 8 && AreTumColumns(*columns)) return ReferenceFormat::kTum;
  return ReferenceFormat::kTable;
}

// The form of the file as a dataset names it; kAuto: none does.
ReferenceFormat FormatOfDatasets(const fs::path& file) {
  for (const Dataset& dataset : Datasets()) {
    const OwnTruth& truth = dataset.truth;
    if (truth.is_file != nullptr && truth.is_file(file)) return truth.format;
  }
  return ReferenceFormat::kAuto;
}

std::optional<Found> DetectFile(const fs::path& file, std::string* error) {
  if (IsBag(file)) return Found{file, ReferenceFormat::kBag};
  const ReferenceFormat own = FormatOfDatasets(file);
  if (own != ReferenceFormat::kAuto) return Found{file, own};
  const std::optional<ReferenceFormat> format = FormatOfColumns(file, error);
  if (!format) return std::nullopt;
  return Found{file, *format};
}

// What datasets put into the folder; what was looked for goes to `searched`.
std::vector<Found> TruthOfDatasets(const fs::path& folder, std::string* searched) {
  std::vector<Found> found;
  std::error_code ignored;
  for (const Dataset& dataset : Datasets()) {
    for (const TruthFile& known : dataset.truth_files) {
      *searched += known.file + ", ";
      if (!fs::exists(folder / known.file, ignored)) continue;
      found.push_back({folder / known.file, known.format});
    }
    const OwnTruth& truth = dataset.truth;
    if (truth.find == nullptr) continue;
    *searched += truth.files + " (" + dataset.name + "), ";
    if (const auto path = truth.find(folder)) found.push_back({*path, truth.format});
  }
  return found;
}

std::optional<Found> DetectFolder(const fs::path& folder, std::string* error) {
  std::string searched;
  std::vector<Found> found = TruthOfDatasets(folder, &searched);
  // A bag is the ground truth only where there is nothing better.
  if (found.empty() && FormOfBags(folder)) found.push_back({folder, ReferenceFormat::kBag});
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    *error = folder.string() + ": no ground truth found; looked for " + searched + "bags";
  } else {
    *error = folder.string() + ": several files hold ground truth, name one of them:";
    for (const Found& one : found) *error += " " + one.path.string();
  }
  return std::nullopt;
}

// Null: no dataset has the form to itself.
const OwnTruth* OwnTruthOf(ReferenceFormat format) {
  for (const Dataset& dataset : Datasets()) {
    if (dataset.truth.format == format) return &dataset.truth;
  }
  return nullptr;
}

std::optional<Found> Detect(const fs::path& path, ReferenceFormat format, std::string* error) {
  std::error_code failure;
  if (!fs::exists(path, failure)) {
    *error = path.string() + ": cannot be opened; expected ground truth, a file or a folder";
    return std::nullopt;
  }
  if (format == ReferenceFormat::kAuto) {
    return fs::is_directory(path, failure) ? DetectFolder(path, error) : DetectFile(path, error);
  }
  const OwnTruth* const own = OwnTruthOf(format);
  const bool can_find = own != nullptr && own->find != nullptr;
  return Found{can_find ? own->find(path).value_or(path) : path, format};
}

bool ReadBag(const fs::path& path,
             const std::string& topic,
             Reference* reference,
             std::string* error) {
  std::unique_ptr<MessageSource> bag = OpenMessageSource(
      path, FormOfBags(path).value_or(BagFormat::kRosbag2), MessageLimits(), error);
  if (bag == nullptr) return false;
  auto trajectory = ReadBagTrajectory(std::move(bag), path.string(), topic, error);
  if (!trajectory) return false;
  reference->poses = std::move(trajectory->poses);
  reference->has_rotations = trajectory->has_rotations;
  reference->description = trajectory->description;
  return true;
}

bool Read(const Found& found,
          const ReferenceOptions& options,
          int clip,
          Reference* reference,
          std::string* error) {
  if (found.format == ReferenceFormat::kTum) {
    return ReadReferenceText(found.path, TrajectoryFormat::kTum, reference, error);
  }
  if (found.format == ReferenceFormat::kKitti) {
    return ReadReferenceText(found.path, TrajectoryFormat::kKitti, reference, error);
  }
  if (found.format == ReferenceFormat::kEuroc) {
    return ReadReferenceText(found.path, TrajectoryFormat::kEuroc, reference, error);
  }
  if (found.format == ReferenceFormat::kBag) {
    return ReadBag(found.path, options.topic, reference, error);
  }
  const OwnTruth* const own = OwnTruthOf(found.format);
  if (own != nullptr && own->read != nullptr) return own->read(found.path, clip, reference, error);
  const std::optional<PoseColumns> columns = own != nullptr ? own->columns("") : std::nullopt;
  return ReadReferenceTable(found.path, columns, reference, error);
}

}  // namespace

std::optional<Reference> ReadReference(const fs::path& path,
                                       const ReferenceOptions& options,
                                       int clip,
                                       std::string* error) {
  const std::optional<Found> found = Detect(path, options.format, error);
  Reference reference;
  if (!found || !Read(*found, options, clip, &reference, error) ||
      !CheckPoses(reference.poses, found->path.string(), error)) {
    return std::nullopt;
  }
  reference.warnings = DoubtsAboutPoses(
      reference.poses, reference.has_stamps, reference.has_rotations, found->path.string());
  if (reference.description.empty())
    reference.description = NameOf(found->format) + ", " + found->path.string();
  const char* const what = reference.has_rotations ? " poses (" : " places (";
  reference.description =
      std::to_string(reference.poses.size()) + what + reference.description + ")";
  return reference;
}

}  // namespace radive
