// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/open_scan_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using Format = InputOptions::Format;
using ::testing::AllOf;
using testing::Floats;
using ::testing::HasSubstr;
using testing::TempFolder;

TEST(OpenScanSource, OpensEachFormat) {
  const TempFolder folder;
  folder.Write("0000000.bin", Floats({1.0, 2.0, 3.0}));
  folder.Write("Radar/Continental/1693922345123456789.bin", "");
  folder.Write("radar2_scans.csv", "timestamp_rad,first_point,num_points\n0.1,0,0\n");
  folder.Write("radar2_points.bin", "");
  InputOptions options;
  options.layout = "xyz3";
  options.folder = "Radar/Continental";
  std::string error;
  for (const auto& [format, name] :
       {std::pair(Format::kRaw, "raw float32 scans (xyz3), 1 files in "),
        std::pair(Format::kHercules, "HeRCULES Continental scans, 1 files in ")}) {
    options.format = format;
    const auto source = OpenScanSource(folder.string(), options, &error);
    ASSERT_NE(source, nullptr) << error;
    EXPECT_THAT(source->Description(), HasSubstr(name));
  }
  options.format = Format::kRadarScenes;
  options.folder.clear();
  const auto source = OpenScanSource(folder.string(), options, &error);
  ASSERT_NE(source, nullptr) << error;
  EXPECT_THAT(source->Description(), HasSubstr("RadarScenes radar 2, 1 scans in "));
}

TEST(OpenScanSource, SaysWhichFolderIsMissing) {
  const TempFolder folder;
  folder.Write("file.txt", "a file, no folder");
  for (const Format format : {Format::kRaw, Format::kHercules, Format::kRadarScenes}) {
    InputOptions options;
    options.format = format;
    options.layout = "xyz3";
    std::string error;
    const std::string absent = (folder.path() / "absent").string();
    EXPECT_EQ(OpenScanSource(absent, options, &error), nullptr);
    EXPECT_THAT(error,
                AllOf(HasSubstr(absent), HasSubstr("expected a folder"), HasSubstr("not exist")));
    const std::string file = (folder.path() / "file.txt").string();
    EXPECT_EQ(OpenScanSource(file, options, &error), nullptr);
    EXPECT_THAT(error, AllOf(HasSubstr(file), HasSubstr("it is a file")));
    error.clear();
    EXPECT_EQ(OpenScanSource("", options, &error), nullptr);
    EXPECT_FALSE(error.empty());
  }
}

TEST(OpenScanSource, ChecksTheOptions) {
  InputOptions options;
  options.layout = "x,y,dopler";
  std::string error;
  EXPECT_EQ(OpenScanSource(".", options, &error), nullptr);
  EXPECT_THAT(error, HasSubstr("input.layout"));
}

// The default of Skip(), for sources that cannot seek.
class ThreeScans : public ScanSource {
 public:
  Status Next(RadarScan* scan) override {
    if (position_ == 3) return Status::kEnd;
    scan->stamp_ns = position_++;
    return Status::kScan;
  }
  std::string Description() const override { return "three scans"; }
  std::optional<int> NumScans() const override { return 3; }

 private:
  int position_ = 0;
};

// The error at which a drive of two scans ends when `change` is done to the second after opening.
std::string ErrorAfter(const std::function<void(const std::filesystem::path&)>& change) {
  const TempFolder folder;
  for (const char* name : {"000000.bin", "000001.bin"}) {
    folder.Write(name, Floats({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
  }
  InputOptions options;
  options.format = Format::kRaw;
  options.layout = "xyz3";
  std::string error;
  const auto source = OpenScanSource(folder.string(), options, &error);
  if (source == nullptr) return error;
  RadarScan scan;
  change(folder.path() / "000001.bin");
  ScanSource::Status status = source->Next(&scan);
  while (status == ScanSource::Status::kScan) status = source->Next(&scan);
  return status == ScanSource::Status::kError ? source->error() : "";
}

// A drive that is away says nothing of its scans: they are not empty.
TEST(OpenScanSource, AFileThatIsGoneEndsTheDriveWithAnError) {
  EXPECT_THAT(ErrorAfter([](const auto& file) { std::filesystem::remove(file); }),
              AllOf(HasSubstr("000001.bin"), HasSubstr("No such file")));
}

TEST(OpenScanSource, AFileThatIsCutEndsTheDriveWithAnError) {
  EXPECT_THAT(ErrorAfter([](const auto& file) { std::filesystem::resize_file(file, 12); }),
              AllOf(HasSubstr("000001.bin"), HasSubstr("has 12 bytes, but had 24")));
  EXPECT_EQ(ErrorAfter([](const auto&) {}), "");
}

TEST(ScanSource, SkipReadsAndDropsByDefault) {
  ThreeScans source;
  RadarScan scan;
  EXPECT_EQ(source.Skip(2), ScanSource::Status::kScan);
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 2);
  EXPECT_EQ(source.Skip(1), ScanSource::Status::kEnd);
}

}  // namespace
}  // namespace radive
