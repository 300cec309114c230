// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/open_scan_writer.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <system_error>

#include "radive/io/bags/bag_scan_writer.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/points/point_file_writer.h"
#include "radive/io/points/raw_layout.h"
#include "radive/util/number_text.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

using Naming = WrittenForm::Naming;
using Returns = std::vector<RadarReturn>;

// A file a scan.
struct FileForm {
  WrittenForm form;
  std::string extension;
  std::function<std::string(const Returns& returns)> bytes;
};

// Forms of no dataset, in radar/NNNNNN.
FileForm PlainForm(const char* word, const char* extension, std::string (*bytes)(const Returns&)) {
  FileForm plain;
  plain.form.word = word;
  plain.form.folder = "radar";
  plain.extension = extension;
  plain.bytes = bytes;
  return plain;
}

FileForm FormOf(const DatasetSensor& sensor) {
  const RawLayout layout = KnownLayout(sensor.written.columns);
  const double offset = sensor.written.power_offset;
  const bool is_pcd = sensor.format == InputOptions::Format::kPcd;
  return {sensor.written, sensor.extension, [=](const Returns& returns) {
            return (is_pcd ? PcdRecordBytes : RecordBytes)(returns, layout, offset);
          }};
}

const std::vector<FileForm>& FileForms() {
  static const std::vector<FileForm>* const forms = [] {
    auto* const list = new std::vector<FileForm>{
        PlainForm(
            "raw", ".bin", [](const Returns& r) { return RecordBytes(r, KnownLayout("xyzdp5")); }),
        PlainForm(
            "pcd_ascii", ".pcd", [](const Returns& r) { return PcdBytes(r, PcdEncoding::kAscii); }),
        PlainForm("pcd_binary",
                  ".pcd",
                  [](const Returns& r) { return PcdBytes(r, PcdEncoding::kBinary); }),
        PlainForm("pcd_compressed",
                  ".pcd",
                  [](const Returns& r) { return PcdBytes(r, PcdEncoding::kCompressed); }),
        PlainForm(
            "ply_ascii", ".ply", [](const Returns& r) { return PlyBytes(r, PlyEncoding::kAscii); }),
        PlainForm("ply_binary",
                  ".ply",
                  [](const Returns& r) { return PlyBytes(r, PlyEncoding::kLittleEndian); }),
        PlainForm("ply_big_endian",
                  ".ply",
                  [](const Returns& r) { return PlyBytes(r, PlyEncoding::kBigEndian); }),
        PlainForm("csv", ".csv", CsvBytes),
        PlainForm("npy", ".npy", NpyBytes)};
    for (const Dataset& dataset : Datasets()) {
      for (const DatasetSensor& sensor : dataset.sensors) {
        if (!sensor.written.word.empty()) list->push_back(FormOf(sensor));
      }
    }
    return list;
  }();
  return *forms;
}

std::string NameOf(Naming naming, int number, std::int64_t stamp_ns) {
  switch (naming) {
    case Naming::kNumber6:
      return FormatText("%06d", number);
    case Naming::kNumber5:
      return FormatText("%05d", number);
    case Naming::kRadarPointcloud:
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
  PointFileWriter(const FileForm& file, const fs::path& folder)
      : file_(file), folder_(folder / file.form.folder), drive_(folder) {}

  bool Add(const RadarScan& scan, std::string* error) override {
    const std::string name = NameOf(file_.form.naming, number_++, scan.stamp_ns) + file_.extension;
    times_ += std::to_string(scan.stamp_ns) + "\n";
    return WriteFile(folder_ / name, file_.bytes(scan.returns), error);
  }

  bool Finish(std::string* error) override {
    return !file_.form.has_times || WriteFile(drive_ / "times.txt", times_, error);
  }

 private:
  const FileForm& file_;
  const fs::path folder_;  // of the scans
  const fs::path drive_;
  int number_ = 0;
  std::string times_;
};

}  // namespace

const std::vector<std::string>& ScanWriterNames() {
  static const std::vector<std::string>* const names = [] {
    auto* const list = new std::vector<std::string>();
    for (const FileForm& file : FileForms()) list->push_back(file.form.word);
    const std::vector<std::string>& bags = BagScanWriterNames();
    list->insert(list->end(), bags.begin(), bags.end());
    return list;
  }();
  return *names;
}

std::unique_ptr<ScanWriter> OpenScanWriter(const std::string& format,
                                           const fs::path& folder,
                                           std::string* error) {
  for (const FileForm& file : FileForms()) {
    if (format != file.form.word) continue;
    const fs::path scans = folder / file.form.folder;
    std::error_code failure;
    fs::create_directories(scans, failure);
    if (failure) {
      *error = scans.string() + ": cannot be created: " + SystemMessage(failure);
      return nullptr;
    }
    return std::make_unique<PointFileWriter>(file, folder);
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
