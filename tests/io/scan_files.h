// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/scans/scan_source.h"

namespace radive::testing {

// A folder of its own for a test, gone with the object.
class TempFolder {
 public:
  TempFolder() {
    std::string name = ::testing::TempDir() + "radive_XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string string() const { return path_.string(); }

  // Writes `content` to `name` in the folder; makes the folders in between.
  void Write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
  }

 private:
  std::filesystem::path path_;
};

// Numbers as little-endian float32, as the files have them.
inline std::string Floats(std::initializer_list<double> values) {
  std::string bytes;
  for (const double value : values) AppendLittleEndian(static_cast<float>(value), &bytes);
  return bytes;
}

inline const char* LfsPointer() {
  return "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
}

// Every scan that is left in the source, which must end without an error.
inline std::vector<RadarScan> ReadAll(ScanSource* source) {
  std::vector<RadarScan> scans;
  RadarScan scan;
  ScanSource::Status status;
  while ((status = source->Next(&scan)) == ScanSource::Status::kScan) scans.push_back(scan);
  EXPECT_EQ(status, ScanSource::Status::kEnd) << source->error();
  return scans;
}

inline std::vector<std::int64_t> Stamps(const std::vector<RadarScan>& scans) {
  std::vector<std::int64_t> stamps;
  for (const RadarScan& scan : scans) stamps.push_back(scan.stamp_ns);
  return stamps;
}

// The x of the first return of each scan: tells which file was read.
inline std::vector<double> FirstX(const std::vector<RadarScan>& scans) {
  std::vector<double> values;
  for (const RadarScan& scan : scans) {
    values.push_back(scan.returns.empty() ? -1.0 : scan.returns.front().position.x());
  }
  return values;
}

}  // namespace radive::testing
