// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/open_scan_writer.h"

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "radive/io/bags/bag_scan_writer.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/io/points/point_file_writer.h"
#include "radive/util/number_text.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

enum class Naming { kNumber6, kNumber5, kNumber, kNanoseconds, kSeconds };

struct FileForm {
  const char* name;
  const char* folder;
  const char* extension;
  Naming naming;
  bool has_times;
  std::string (*bytes)(const std::vector<RadarReturn>& returns);
};

using Returns = std::vector<RadarReturn>;

const FileForm kFileForms[] = {
    {"raw", "radar", ".bin", Naming::kNumber6, true, RawBytes},
    {"pcd_ascii",
     "radar",
     ".pcd",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PcdBytes(returns, PcdEncoding::kAscii); }},
    {"pcd_binary",
     "radar",
     ".pcd",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PcdBytes(returns, PcdEncoding::kBinary); }},
    {"pcd_compressed",
     "radar",
     ".pcd",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PcdBytes(returns, PcdEncoding::kCompressed); }},
    {"ply_ascii",
     "radar",
     ".ply",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PlyBytes(returns, PlyEncoding::kAscii); }},
    {"ply_binary",
     "radar",
     ".ply",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PlyBytes(returns, PlyEncoding::kLittleEndian); }},
    {"ply_big_endian",
     "radar",
     ".ply",
     Naming::kNumber6,
     true,
     [](const Returns& returns) { return PlyBytes(returns, PlyEncoding::kBigEndian); }},
    {"csv", "radar", ".csv", Naming::kNumber6, true, CsvBytes},
    {"npy", "radar", ".npy", Naming::kNumber6, true, NpyBytes},
    {"hercules", "Radar/Continental", ".bin", Naming::kNanoseconds, true, HerculesBytes},
    {"snail", "ars548/points", ".pcd", Naming::kSeconds, true, SnailPcdBytes},
    {"aeva", "LiDAR/Aeva", ".bin", Naming::kNanoseconds, true, AevaBytes},
    {"tj4d", "training/velodyne", ".bin", Naming::kNumber6, true, Tj4dBytes},
    {"coloradar", "single_chip/pointclouds/data", ".bin", Naming::kNumber, true, ColoRadarBytes},
    {"vod", "radar/training/velodyne", ".bin", Naming::kNumber5, false, VodBytes},
};

std::string NameOf(Naming naming, int number, std::int64_t stamp_ns) {
  switch (naming) {
    case Naming::kNumber6:
      return FormatText("%06d", number);
    case Naming::kNumber5:
      return FormatText("%05d", number);
    case Naming::kNumber:
      return "radar_pointcloud_" + std::to_string(number);
    case Naming::kNanoseconds:
      return FormatText("%019lld", static_cast<long long>(stamp_ns));
    case Naming::kSeconds:
      return FormatStamp(stamp_ns);
  }
  return "";
}

// One file a scan.
class PointFileWriter : public ScanWriter {
 public:
  PointFileWriter(const FileForm& form, const fs::path& folder) : form_(form), folder_(folder) {}

  bool Add(const RadarScan& scan, std::string* error) override {
    const std::string name = NameOf(form_.naming, number_++, scan.stamp_ns) + form_.extension;
    times_ += std::to_string(scan.stamp_ns) + "\n";
    return WriteFile(folder_ / form_.folder / name, form_.bytes(scan.returns), error);
  }

  bool Finish(std::string* error) override {
    return !form_.has_times || WriteFile(folder_ / "times.txt", times_, error);
  }

 private:
  const FileForm& form_;
  const fs::path folder_;
  int number_ = 0;
  std::string times_;
};

}  // namespace

const std::vector<std::string>& ScanWriterNames() {
  static const std::vector<std::string>* const names = [] {
    auto* const list = new std::vector<std::string>();
    for (const FileForm& form : kFileForms) list->emplace_back(form.name);
    const std::vector<std::string>& bags = BagScanWriterNames();
    list->insert(list->end(), bags.begin(), bags.end());
    return list;
  }();
  return *names;
}

std::unique_ptr<ScanWriter> OpenScanWriter(const std::string& format,
                                           const fs::path& folder,
                                           std::string* error) {
  for (const FileForm& form : kFileForms) {
    if (format != form.name) continue;
    std::error_code failure;
    fs::create_directories(folder / form.folder, failure);
    if (failure) {
      *error = (folder / form.folder).string() + ": cannot be created: " + SystemMessage(failure);
      return nullptr;
    }
    return std::make_unique<PointFileWriter>(form, folder);
  }
  const std::vector<std::string>& bags = BagScanWriterNames();
  if (std::find(bags.begin(), bags.end(), format) != bags.end()) {
    return OpenBagScanWriter(format, folder, error);
  }
  std::string names;
  for (const std::string& name : ScanWriterNames()) names += " " + name;
  *error = "scans cannot be written as '" + format + "', expected one of" + names;
  return nullptr;
}

}  // namespace radive
