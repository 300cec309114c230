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
#include "radive/io/datasets/dicp_calibration.h"
#include "radive/io/datasets/radarscenes_hdf5.h"
#include "radive/io/datasets/raflow_source.h"
#include "radive/io/datasets/vod_poses.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/io/scans/scan_stamps.h"
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

// Where the datasets put their ground truth, below the folder of the drive.
constexpr struct {
  const char* file;
  ReferenceFormat format;
} kKnownFiles[] = {
    {"gt_odom.txt", ReferenceFormat::kTum},
    {"PR_GT/Continental_gt.txt", ReferenceFormat::kTum},
    {"PR_GT/Aeva_gt.txt", ReferenceFormat::kTum},
    {"ref_tls_T_xt32.csv", ReferenceFormat::kTable},
    {"utm50r_T_xt32.txt", ReferenceFormat::kTum},
    {"ref_poses.txt", ReferenceFormat::kDicp},
    {"applanix/aeva_poses.csv", ReferenceFormat::kBoreas},
    {"groundtruth/groundtruth_poses.txt", ReferenceFormat::kColoRadar},
    {"groundtruth_poses.txt", ReferenceFormat::kColoRadar},
    {"gt_poses_kitti.txt", ReferenceFormat::kKitti},
};

const std::string& NameOf(ReferenceFormat format) {
  return ReferenceFormatNames()[static_cast<std::size_t>(format)];
}

// A file or folder, and how it is to be read.
struct Found {
  fs::path path;
  ReferenceFormat format = ReferenceFormat::kAuto;
};

std::vector<std::string> Files(const fs::path& folder, const char* extension) {
  std::vector<std::string> names;
  std::string ignored;
  ListFiles(folder, extension, &names, &ignored);
  return names;
}

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

// Whether the first line has names of columns that FindPoseColumns() knows; those of Boreas are
// not.
bool NamesTell(const fs::path& file) {
  std::string text, ignored;
  if (!ReadWholeFile(file, &text, &ignored)) return false;
  TextLines lines(text);
  std::string_view first;
  return lines.Next(&first) && ColumnsByName(SplitNames(first)).has_value();
}

std::optional<Found> DetectFile(const fs::path& file, std::string* error) {
  const std::string name = file.filename().string();
  std::int64_t sequence, sample;
  if (IsBag(file)) return Found{file, ReferenceFormat::kBag};
  if (EndsWith(name, "_scans.csv") || file.extension() == ".h5")
    return Found{file, ReferenceFormat::kRadarScenes};
  if (EndsWith(name, "_poses.csv") && !NamesTell(file))
    return Found{file, ReferenceFormat::kBoreas};
  if (name == "ref_poses.txt") return Found{file, ReferenceFormat::kDicp};
  if (name == "groundtruth_poses.txt") return Found{file, ReferenceFormat::kColoRadar};
  if (ParseRaFlowName(name, &sequence, &sample)) return Found{file, ReferenceFormat::kRaFlow};
  const std::optional<ReferenceFormat> format = FormatOfColumns(file, error);
  if (!format) return std::nullopt;
  return Found{file, *format};
}

bool HoldsRaFlow(const fs::path& folder) {
  for (const std::string& name : Files(folder, ".json")) {
    std::int64_t sequence, sample;
    if (ParseRaFlowName(name, &sequence, &sample)) return true;
  }
  return false;
}

std::optional<Found> DetectFolder(const fs::path& folder, std::string* error) {
  std::vector<Found> found;
  std::error_code ignored;
  for (const auto& known : kKnownFiles) {
    if (fs::exists(folder / known.file, ignored))
      found.push_back({folder / known.file, known.format});
  }
  if (!Files(folder, "_scans.csv").empty() || FindRadarScenesHdf5(folder))
    found.push_back({folder, ReferenceFormat::kRadarScenes});
  if (HoldsRaFlow(folder)) found.push_back({folder, ReferenceFormat::kRaFlow});
  if (const auto poses = FindVodPoses(folder)) found.push_back({*poses, ReferenceFormat::kVod});
  // A bag is the ground truth only where there is nothing better.
  if (found.empty() && FormOfBags(folder)) found.push_back({folder, ReferenceFormat::kBag});
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    *error = folder.string() +
             ": no ground truth found; looked for pose/*.json (View-of-Delft), radarK_scans.csv, "
             "radar_seqs-*.json, bags";
    for (const auto& known : kKnownFiles) *error += std::string(", ") + known.file;
  } else {
    *error = folder.string() + ": several files hold ground truth, name one of them:";
    for (const Found& one : found) *error += " " + one.path.string();
  }
  return std::nullopt;
}

std::optional<Found> Detect(const fs::path& path, ReferenceFormat format, std::string* error) {
  std::error_code failure;
  if (!fs::exists(path, failure)) {
    *error = path.string() + ": cannot be opened; expected ground truth, a file or a folder";
    return std::nullopt;
  }
  if (format == ReferenceFormat::kVod) {
    return Found{FindVodPoses(path).value_or(path), format};
  }
  if (format != ReferenceFormat::kAuto) return Found{path, format};
  return fs::is_directory(path, failure) ? DetectFolder(path, error) : DetectFile(path, error);
}

bool ReadPoses(std::optional<RecordedTrajectory> poses, bool has_stamps, Reference* reference) {
  if (!poses) return false;
  reference->poses = *std::move(poses);
  reference->has_stamps = has_stamps;
  return true;
}

bool ReadText(const fs::path& file,
              TrajectoryFormat format,
              Reference* reference,
              std::string* error) {
  return ReadPoses(
      ReadTrajectory(file, format, error), format != TrajectoryFormat::kKitti, reference);
}

bool ReadTable(const fs::path& file,
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

bool ReadColoRadar(const fs::path& path, Reference* reference, std::string* error) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / "groundtruth_poses.txt" : path;
  const fs::path stamp_file = file.parent_path() / "timestamps.txt";
  if (!ReadTable(file, ColoRadarColumns(), reference, error)) return false;
  const std::optional<StampSequence> sequence = ReadStampFile(stamp_file, kAssumedRate, error);
  if (!sequence) return false;
  reference->has_stamps = true;
  const std::vector<std::int64_t>& stamps_ns = sequence->stamps_ns;
  if (stamps_ns.size() != reference->poses.size()) {
    *error = stamp_file.string() + ": has " + std::to_string(stamps_ns.size()) +
             " stamps, expected one for each of the " + std::to_string(reference->poses.size()) +
             " poses of " + file.string();
    return false;
  }
  for (std::size_t i = 0; i < stamps_ns.size(); ++i) {
    reference->poses[i].stamp_ns = stamps_ns[i];
    reference->poses[i].stamp_s = StampSeconds(stamps_ns[i]);
  }
  return true;
}

// Poses of the vehicle, turned into those of its sensor where calibration.json lies beside them.
bool ReadDicp(const fs::path& path, Reference* reference, std::string* error) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / "ref_poses.txt" : path;
  if (!ReadText(file, TrajectoryFormat::kTum, reference, error)) return false;
  const fs::path calibration = file.parent_path() / "calibration.json";
  if (!fs::exists(calibration, ignored)) return true;
  std::string text;
  MatrixPose T_vehicle_sensor;
  if (!ReadWholeFile(calibration, &text, error)) return false;
  if (!ParseDicpCalibration(text, &T_vehicle_sensor)) {
    *error =
        calibration.string() + ": expected T_V_to_S with translation x y z and quaternion w x y z";
    return false;
  }
  for (RecordedPose& pose : reference->poses)
    pose.T_world_body = pose.T_world_body * T_vehicle_sensor;
  return true;
}

// The tables of all radars: each has the pose of the car at the odometry's stamp next to each scan.
bool ReadRadarScenes(const fs::path& path, Reference* reference, std::string* error) {
  std::error_code ignored;
  const std::optional<fs::path> hdf5 = FindRadarScenesHdf5(path);
  if (hdf5) {
    return ReadPoses(ReadRadarScenesOdometry(*hdf5, error), /*has_stamps=*/true, reference);
  }
  std::vector<fs::path> files = {path};
  if (fs::is_directory(path, ignored)) {
    files.clear();
    for (const std::string& name : Files(path, "_scans.csv")) files.push_back(path / name);
  }
  RecordedTrajectory& all = reference->poses;
  for (const fs::path& file : files) {
    std::string text;
    if (!ReadWholeFile(file, &text, error)) return false;
    TextLines lines(text);
    std::string_view names;
    lines.Next(&names);
    const std::optional<PoseColumns> columns = RadarScenesColumns(names);
    if (!columns) {
      *error = file.string() +
               ":1: expected the names of the columns, among them timestamp_odom, x, y and yaw, "
               "found " +
               Quoted(names);
      return false;
    }
    RecordedTrajectory poses;
    if (!ParsePoseTable(text, *columns, file.string(), &poses, error)) return false;
    all.insert(all.end(), poses.begin(), poses.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const RecordedPose& a, const RecordedPose& b) {
    return a.stamp_ns < b.stamp_ns;
  });
  all.erase(std::unique(all.begin(),
                        all.end(),
                        [](const RecordedPose& a, const RecordedPose& b) {
                          return a.stamp_ns == b.stamp_ns;
                        }),
            all.end());
  if (all.empty()) *error = path.string() + ": expected radarK_scans.csv, found none";
  return !all.empty();
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
  switch (found.format) {
    case ReferenceFormat::kTum:
      return ReadText(found.path, TrajectoryFormat::kTum, reference, error);
    case ReferenceFormat::kKitti:
      return ReadText(found.path, TrajectoryFormat::kKitti, reference, error);
    case ReferenceFormat::kEuroc:
      return ReadText(found.path, TrajectoryFormat::kEuroc, reference, error);
    case ReferenceFormat::kTable:
      return ReadTable(found.path, std::nullopt, reference, error);
    case ReferenceFormat::kBoreas:
      return ReadTable(found.path, BoreasColumns(), reference, error);
    case ReferenceFormat::kDicp:
      return ReadDicp(found.path, reference, error);
    case ReferenceFormat::kColoRadar:
      return ReadColoRadar(found.path, reference, error);
    case ReferenceFormat::kRadarScenes:
      return ReadRadarScenes(found.path, reference, error);
    case ReferenceFormat::kVod:
      return ReadPoses(ReadVodPoses(found.path, error), /*has_stamps=*/false, reference);
    case ReferenceFormat::kRaFlow:
      return ReadPoses(ReadRaFlowPoses(found.path, clip, error), /*has_stamps=*/true, reference);
    case ReferenceFormat::kBag:
      return ReadBag(found.path, options.topic, reference, error);
    case ReferenceFormat::kAuto:
      break;
  }
  return false;
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
