// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/detect_format.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include "radive/io/bags/open_message_source.h"
#include "radive/io/bags/point_cloud_messages.h"
#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/datasets/raw_evidence.h"
#include "radive/io/points/raw_layout.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
using Format = InputOptions::Format;

constexpr struct {
  const char* extension;
  Format format;
} kExtensions[] = {
    {".pcd", Format::kPcd},
    {".ply", Format::kPly},
    {".npy", Format::kNpy},
    {".csv", Format::kCsv},
    {".yaml", Format::kYaml},
};

constexpr const char* kUsualFolders[] = {"",
                                         "radar",
                                         "velodyne",
                                         "training/velodyne",
                                         "radar/training/velodyne",
                                         "points",
                                         "pointclouds"};

std::string FirstBytes(const fs::path& path) {
  std::string bytes(64, '\0');
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return "";
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  std::fclose(file);
  return bytes;
}

Format FormatOf(BagFormat format) {
  switch (format) {
    case BagFormat::kRosbag1:
      return Format::kRosbag1;
    case BagFormat::kRosbag2:
      return Format::kRosbag2;
    case BagFormat::kMcap:
      break;
  }
  return Format::kMcap;
}

// "RadarScenes, RaFlow and Boreas": those that are known by their files or folders.
std::string KnownDatasets() {
  std::vector<std::string> names;
  for (const Dataset& dataset : Datasets()) {
    const auto has_folders = [](const DatasetSensor& sensor) { return !sensor.folders.empty(); };
    if (dataset.recognise != nullptr ||
        std::any_of(dataset.sensors.begin(), dataset.sensors.end(), has_folders)) {
      names.push_back(dataset.name);
    }
  }
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return list;
}

class Detection {
 public:
  Detection(const fs::path& path, InputOptions* options, std::string* reason, std::string* error)
      : path_(path), options_(options), reason_(reason), error_(error) {}

  bool Run() {
    std::error_code failure;
    const fs::file_status status = fs::status(path_, failure);
    if (fs::is_regular_file(status)) return File();
    if (!fs::is_directory(status)) {
      return Refuse(
          std::string("expected a folder with radar scans, a bag or a point file, but it ") +
          (fs::exists(status) ? "is neither file nor folder" : "does not exist"));
    }
    // Their map would be a scan, and their tables drives.
    if (fs::exists(path_ / "run.json", failure) &&
        fs::exists(path_ / "trajectory_tum.txt", failure)) {
      return Refuse(
          "expected radar scans, but holds the results of a run (run.json, trajectory_tum.txt)");
    }
    return MetadataOfRosbag2() || BagFiles() || Scans();
  }

 private:
  // What is no bag.
  bool Scans() {
    if (DatasetByFiles()) return true;
    if (options_->folder.empty()) {
      bool is_ambiguous = false;
      if (KnownFolder(&is_ambiguous)) return true;
      if (is_ambiguous) return false;
    }
    return PointFiles();
  }

  bool Refuse(const std::string& what) {
    *error_ = path_.string() + ": " + what;
    return false;
  }

  bool Take(Format format, const std::string& reason) {
    options_->format = format;
    *reason_ = reason;
    return true;
  }

  bool File() {
    if (IsLfsPointer(path_, error_)) return false;
    const std::string bytes = FirstBytes(path_);
    const std::string extension = LowerCase(path_.extension().string());
    if (StartsWith(bytes, "#ROSBAG V")) return Take(Format::kRosbag1, "starts with #ROSBAG");
    if (StartsWith(bytes, "\x89MCAP0\r\n")) return Take(Format::kMcap, "starts with MCAP's magic");
    if (StartsWith(bytes, "SQLite format 3")) {
      return Take(Format::kRosbag2, "starts with 'SQLite format 3'");
    }
    if (const auto bag = BagFormatOfName(path_.filename().string())) {
      if (StartsWith(bytes, "\x28\xB5\x2F\xFD")) {
        return Take(FormatOf(*bag), "a bag packed with zstd, by its name");
      }
      return Refuse("the name ends in " + extension + ", but the first bytes are not those of " +
                    "such a file, found " + Quoted(bytes.substr(0, 16)));
    }
    if (StartsWith(bytes, "\x93NUMPY")) return Take(Format::kNpy, "starts with \\x93NUMPY");
    if (DatasetByFiles()) return true;
    if (StartsWith(LowerCase(bytes), "ply\n") || StartsWith(LowerCase(bytes), "ply\r")) {
      return Take(Format::kPly, "starts with 'ply'");
    }
    for (const auto& known : kExtensions) {
      if (extension == known.extension) return Take(known.format, "ends in " + extension);
    }
    if (extension == ".bin") return RawFile(path_, "");
    return Refuse(
        "cannot tell what this file is; expected a bag (.bag, .mcap, .db3), points "
        "(.pcd, .ply, .csv, .npy, .yaml, .bin), or a folder of them, found " +
        Quoted(bytes.substr(0, 16)));
  }

  std::vector<std::string> Files(const fs::path& folder, const std::string& extension) {
    std::vector<std::string> names;
    std::string ignored;
    ListFiles(folder, extension, &names, &ignored);
    return names;
  }

  bool MetadataOfRosbag2() {
    std::error_code ignored;
    if (!fs::exists(path_ / "metadata.yaml", ignored)) return false;
    std::string text;
    ReadWholeFile(path_ / "metadata.yaml", &text, error_);
    if (text.find("storage_identifier: mcap") != std::string::npos) {
      return Take(Format::kMcap, "metadata.yaml says storage_identifier: mcap");
    }
    if (text.find("storage_identifier: sqlite3") != std::string::npos) {
      return Take(Format::kRosbag2, "metadata.yaml says storage_identifier: sqlite3");
    }
    return false;
  }

  bool BagFiles() {
    for (const BagFormat format : {BagFormat::kRosbag1, BagFormat::kMcap, BagFormat::kRosbag2}) {
      std::vector<fs::path> files;
      std::string ignored;
      ListBagFiles(path_, format, &files, &ignored);
      if (files.empty()) continue;
      const std::string what = "holds " + std::to_string(files.size()) +
                               (files.size() == 1 ? " bag, " : " bags, such as ") +
                               files.front().filename().string();
      return ScansBesideBag(format, what) || Take(FormatOf(format), what + *reason_);
    }
    return false;
  }

  // A bag may be of another sensor than the scans beside it. True when they are what to read;
  // otherwise `reason_` says that they are not.
  bool ScansBesideBag(BagFormat format, const std::string& bag) {
    InputOptions options = *options_;
    std::string reason, ignored;
    reason_->clear();
    Detection scans(path_, &options, &reason, &ignored);
    if (!scans.Scans() || options.format == Format::kYaml) return false;
    const std::unique_ptr<MessageSource> source =
        OpenMessageSource(path_, format, MessageLimits(), &ignored);
    const bool has_clouds =
        source != nullptr &&
        std::any_of(
            source->topics().begin(), source->topics().end(), [](const MessageTopic& topic) {
              return PointCloudTypeOf(topic) != PointCloudType::kNone;
            });
    if (has_clouds) {
      *reason_ = "; not read are the scans beside it (" + reason + "), see input.format";
      return false;
    }
    *options_ = options;
    return Take(options.format, reason + "; it also " + bag + ", without point clouds");
  }

  // By the names of files, or their first bytes.
  bool DatasetByFiles() {
    for (const Dataset& dataset : Datasets()) {
      std::string what;
      if (dataset.recognise != nullptr && dataset.recognise(path_, options_->folder, &what)) {
        return Take(dataset.sensors.front().format, what);
      }
    }
    return false;
  }

  // A sensor's scans that were found.
  struct KnownScans {
    const DatasetSensor* sensor = nullptr;
    std::string folder;  // as the sensor has it
    std::string layout;
    fs::path place;
  };

  // Those of the sensor in the drive, or in the path if that is such a folder itself.
  KnownScans ScansOf(const DatasetSensor& sensor) {
    KnownScans found;
    std::error_code ignored;
    const auto is_here = [&](const std::string& file) { return fs::exists(path_ / file, ignored); };
    if (!sensor.siblings.empty() &&
        std::none_of(sensor.siblings.begin(), sensor.siblings.end(), is_here)) {
      return found;
    }
    std::vector<std::string> layouts = sensor.layouts;
    if (layouts.empty()) layouts = {""};
    for (const std::string& folder : sensor.folders) {
      const fs::path place = IsItself(folder) ? path_ : path_ / folder;
      if (Files(place, sensor.extension).empty()) continue;
      for (const std::string& layout : layouts) {
        // Of two releases of a dataset the one whose records fit the files.
        const bool fits = Fits(layout, sensor.extension, place);
        if (found.sensor == nullptr || fits) found = {&sensor, folder, layout, place};
        if (fits) return found;
      }
    }
    return found;
  }

  // The drive's form by the names of its folders.
  bool KnownFolder(bool* is_ambiguous) {
    KnownScans found;
    for (const Dataset& dataset : Datasets()) {
      for (const DatasetSensor& sensor : dataset.sensors) {
        const KnownScans other = ScansOf(sensor);
        if (other.sensor == nullptr) continue;
        if (found.sensor == nullptr) found = other;
        // With input.radar all the first says what dataset it is.
        if (found.sensor == &sensor || options_->radar == "all") continue;
        *is_ambiguous = true;
        return Refuse("holds " + found.sensor->name + " (" + found.folder + ") and " + sensor.name +
                      " (" + other.folder +
                      "); take a configuration from configs/, or say with input.folder which");
      }
    }
    if (found.sensor == nullptr) return KnownFolderBelow();
    if (found.sensor->below.empty()) {
      options_->folder = found.place == path_ ? "." : found.folder;
    }
    return TakeSensor(found);
  }

  bool IsItself(const std::string& folder) const {
    std::string path = fs::absolute(path_).lexically_normal().generic_string();
    if (EndsWith(path, "/")) path.pop_back();
    return EndsWith(path, "/" + folder);
  }

  // Whether the records of a layout divide the first file that is not empty.
  bool Fits(const std::string& layout, const std::string& extension, const fs::path& folder) {
    if (layout.empty()) return true;
    for (const std::string& name : Files(folder, extension)) {
      std::error_code failure;
      const std::uintmax_t size = fs::file_size(folder / name, failure);
      if (!failure && size > 0) return size % KnownLayout(layout).record_size == 0;
    }
    return false;
  }

  // Users unpack archives into folders of their own.
  bool KnownFolderBelow() {
    std::error_code failure;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(path_, options, failure), end; !failure && it != end;
         it.increment(failure)) {
      std::error_code ignored;
      if (it.depth() >= 4) it.disable_recursion_pending();
      if (!it->is_directory(ignored)) continue;
      for (const Dataset& dataset : Datasets()) {
        for (const DatasetSensor& sensor : dataset.sensors) {
          if (sensor.below.empty() || it->path().filename() != sensor.below ||
              Files(it->path(), sensor.extension).empty()) {
            continue;
          }
          return TakeSensor(
              {&sensor, "", sensor.layouts.empty() ? "" : sensor.layouts.front(), it->path()});
        }
      }
    }
    return false;
  }

  bool TakeSensor(const KnownScans& found) {
    if (options_->layout.empty()) options_->layout = found.layout;
    return Take(
        found.sensor->format,
        found.sensor->name + ": *" + found.sensor->extension + " in " + found.place.string());
  }

  // By the extensions of the files in the usual places.
  bool PointFiles() {
    std::vector<std::string> folders(std::begin(kUsualFolders), std::end(kUsualFolders));
    if (!options_->folder.empty()) folders = {options_->folder};
    for (const std::string& folder : folders) {
      const fs::path place = folder.empty() ? path_ : path_ / folder;
      for (const auto& known : kExtensions) {
        const std::size_t count = Files(place, known.extension).size();
        if (count == 0) continue;
        options_->folder = folder.empty() ? "." : folder;
        return Take(known.format,
                    std::to_string(count) + " files *" + known.extension + " in " + place.string());
      }
      for (const std::string& name : Files(place, ".bin")) {
        std::error_code ignored;
        if (fs::file_size(place / name, ignored) == 0) continue;
        return RawFile(place / name, folder.empty() ? "." : folder);
      }
    }
    return Refuse(
        "no scans found; looked for bags (*.bag, *.mcap, *.db3, metadata.yaml), point files "
        "(*.pcd, "
        "*.ply, *.npy, *.csv, *.bin) here and in radar/, velodyne/, training/velodyne/, points/, "
        "and for the folders of " +
        KnownDatasets());
  }

  // A raw file says nothing of itself: its numbers must prove a layout, or the user must know.
  bool RawFile(const fs::path& file, const std::string& folder) {
    if (options_->folder.empty()) options_->folder = folder;
    if (!options_->layout.empty()) return Take(Format::kRaw, "*.bin, input.layout is set");
    std::string bytes;
    if (!ReadWholeFile(file, &bytes, error_)) return false;
    std::string evidence;
    const std::string layout = ProvenLayout(bytes, &evidence);
    if (!layout.empty()) {
      options_->layout = layout;
      return Take(Format::kRaw, "raw records, layout " + layout + ": " + evidence);
    }
    std::string fitting;
    for (const std::string& name : LayoutsOfSize(bytes.size())) {
      fitting += (fitting.empty() ? "" : ", ") + name;
    }
    return Refuse("holds raw files, which do not tell their columns; set input.layout (" +
                  file.filename().string() + " has " + std::to_string(bytes.size()) +
                  " bytes, which fits " + (fitting.empty() ? "no known layout" : fitting) +
                  "), or take the dataset's configuration from configs/");
  }

  const fs::path path_;
  InputOptions* const options_;
  std::string* const reason_;
  std::string* const error_;
};

}  // namespace

bool DetectFormat(const fs::path& path,
                  InputOptions* options,
                  std::string* reason,
                  std::string* error) {
  if (options->format != Format::kAuto) {
    *reason = "as set";
    return true;
  }
  return Detection(path, options, reason, error).Run();
}

}  // namespace radive
