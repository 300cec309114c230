// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/point_file_source.h"

#include <glog/logging.h>

#include <optional>
#include <utility>
#include <vector>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/points/csv_points.h"
#include "radive/io/points/csv_text.h"
#include "radive/io/points/field_matching.h"
#include "radive/io/points/npy.h"
#include "radive/io/points/pcd.h"
#include "radive/io/points/ply.h"
#include "radive/io/points/raw_layout.h"
#include "radive/io/points/yaml_points.h"
#include "radive/io/scans/csv_drive_source.h"
#include "radive/io/scans/point_folder_source.h"

namespace radive {
namespace {

// The names of the columns of an npy file; empty: by their number.
std::vector<std::string> ColumnNames(const InputOptions& options) {
  if (options.layout.empty()) return {};
  std::string error;
  const std::optional<RawLayout> layout = ParseRawLayout(options.layout, &error);
  if (!layout) return {};
  std::vector<std::string> names(layout->record_size / 4, "_");
  for (const PointField& field : layout->fields) names[field.offset / 4] = field.name;
  return names;
}

// By the names of the columns of a text table.
bool HoldsPoints(const std::filesystem::path& file, const InputOptions& options) {
  std::string text, ignored;
  if (!ReadWholeFile(file, &text, &ignored)) return true;  // it is a scan that cannot be read
  TextLines lines(text);
  const std::optional<CsvHead> head = ReadCsvHead(&lines, &ignored);
  if (!head) return false;
  std::vector<PointField> fields;
  for (const std::string_view name : head->names) fields.push_back({std::string(name)});
  const std::optional<FieldChoices> choices = ParseFieldChoices(options.fields, &ignored);
  return !HoldsPoses(fields) && choices && MatchFields(fields, *choices, &ignored).has_value();
}

class FormatReader : public PointFileReader {
 public:
  FormatReader(PointFileFormat format, std::vector<std::string> columns)
      : format_(format), columns_(std::move(columns)) {}

  bool Read(std::string_view bytes,
            std::int64_t /*stamp_ns*/,
            PointTable* table,
            std::vector<std::string>* remarks,
            std::string* error) override {
    switch (format_) {
      case PointFileFormat::kPcd:
        return ParsePcd(bytes, table, remarks, error);
      case PointFileFormat::kPly:
        return ParsePly(bytes, table, remarks, error);
      case PointFileFormat::kCsv:
        return ParseCsvPoints(bytes, table, remarks, error);
      case PointFileFormat::kNpy:
        return ParseNpy(bytes, columns_, table, remarks, error);
      case PointFileFormat::kYaml:
        return ParseYamlPoints(bytes, table, remarks, error);
    }
    LOG(FATAL) << "unknown format of point files";
    return false;
  }

 private:
  const PointFileFormat format_;
  const std::vector<std::string> columns_;
};

}  // namespace

const char* NameOf(PointFileFormat format) {
  switch (format) {
    case PointFileFormat::kPcd:
      return "PCD";
    case PointFileFormat::kPly:
      return "PLY";
    case PointFileFormat::kCsv:
      return "CSV";
    case PointFileFormat::kNpy:
      return "npy";
    case PointFileFormat::kYaml:
      return "YAML";
  }
  return "?";
}

const char* ExtensionOf(PointFileFormat format) {
  switch (format) {
    case PointFileFormat::kPcd:
      return ".pcd";
    case PointFileFormat::kPly:
      return ".ply";
    case PointFileFormat::kCsv:
      return ".csv";
    case PointFileFormat::kNpy:
      return ".npy";
    case PointFileFormat::kYaml:
      return ".yaml";
  }
  return "?";
}

std::unique_ptr<ScanSource> OpenPointFileSource(const std::filesystem::path& path,
                                                PointFileFormat format,
                                                const InputOptions& options,
                                                std::string* error,
                                                const std::vector<std::string>& more_folders) {
  ScanFolderQuery query;
  query.extension = ExtensionOf(format);
  query.candidates = {".", "points", "radar", "pointclouds"};
  query.candidates.insert(query.candidates.end(), more_folders.begin(), more_folders.end());
  if (!options.folder.empty()) query.LookOnlyIn(options.folder);
  query.rate = options.rate;
  if (format == PointFileFormat::kCsv) {
    query.holds_points = [&options](const std::filesystem::path& file) {
      return HoldsPoints(file, options);
    };
  }
  std::optional<ScanFolder> folder = OpenScanFolder(path, query, error);
  if (!folder) return nullptr;
  if (format == PointFileFormat::kCsv && folder->names.size() == 1) {
    std::unique_ptr<CsvDriveSource> drive = CsvDriveSource::Open(folder->File(0), options);
    if (drive != nullptr) return drive;
  }
  auto reader = std::make_unique<FormatReader>(format, ColumnNames(options));
  return std::make_unique<PointFolderSource>(
      *std::move(folder), std::move(reader), options, NameOf(format) + std::string(" scans"));
}

}  // namespace radive
