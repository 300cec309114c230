// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/open_scan_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/open/open_scan_source.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;

// 10 Hz from 0, values that need all digits of a float32; the third scan is empty.
std::vector<RadarScan> Drive() {
  std::vector<RadarScan> scans(5);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    scans[k].stamp_ns = static_cast<std::int64_t>(k) * 100000000;
    if (k == 2) continue;
    for (int i = 0; i < 40; ++i) {
      RadarReturn& ret = scans[k].returns.emplace_back();
      ret.position = {5.0 + i / 3.0, (i - 20) / 7.0, i / 900.0 - 0.01};
      ret.doppler = -10.0 * (5.0 + i / 3.0) / ret.position.norm();
      ret.power = i - 10;
    }
  }
  return scans;
}

// What was written comes back, without a word about its form: stamps, and all that is float32.
TEST(ScanWriter, WhatIsWrittenComesBack) {
  const std::vector<RadarScan> drive = Drive();
  for (const std::string& format : ScanWriterNames()) {
    const TempFolder folder;
    std::string error;
    const auto writer = OpenScanWriter(format, folder.path(), &error);
    ASSERT_NE(writer, nullptr) << error;
    for (const RadarScan& scan : drive) ASSERT_TRUE(writer->Add(scan, &error)) << error;
    ASSERT_TRUE(writer->Finish(&error)) << error;
    InputOptions options;
    if (format == "raw") options.layout = "xyzdp5";
    if (format == "vod") options.rate = 10.0;  // it has no stamps
    const auto source = OpenScanSource(folder.string(), options, &error);
    ASSERT_NE(source, nullptr) << format << ": " << error;
    const std::vector<RadarScan> read = testing::ReadAll(source.get());
    // A bag without its index is read all the same, but not in silence.
    const bool has_no_index = format.find("unindexed") != std::string::npos;
    EXPECT_EQ(source->TakeWarnings().empty(), !has_no_index) << format;
    ASSERT_EQ(read.size(), drive.size()) << format;
    const double power_offset = format == "snail" ? 128.0 : 0.0;
    for (std::size_t k = 0; k < drive.size(); ++k) {
      EXPECT_EQ(read[k].stamp_ns, drive[k].stamp_ns) << format;
      ASSERT_EQ(read[k].returns.size(), drive[k].returns.size()) << format;
      for (std::size_t i = 0; i < drive[k].returns.size(); ++i) {
        const RadarReturn& expected = drive[k].returns[i];
        const RadarReturn& actual = read[k].returns[i];
        EXPECT_EQ(actual.position.cast<float>(), expected.position.cast<float>()) << format;
        EXPECT_EQ(static_cast<float>(actual.doppler), static_cast<float>(expected.doppler));
        // Text without types is read as double: the same float32, but not only that.
        if (format == "csv") continue;
        EXPECT_EQ(actual.position, expected.position.cast<float>().cast<double>()) << format;
        EXPECT_EQ(actual.doppler, static_cast<double>(static_cast<float>(expected.doppler)));
        EXPECT_EQ(actual.power, expected.power + power_offset) << format;
      }
    }
  }
}

TEST(ScanWriter, NamesTheFormatsForAnUnknownOne) {
  std::string error;
  EXPECT_EQ(OpenScanWriter("las", ".", &error), nullptr);
  EXPECT_THAT(error, HasSubstr("cannot be written as 'las', expected one of raw pcd_ascii"));
}

}  // namespace
}  // namespace radive
