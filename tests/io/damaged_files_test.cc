// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Damaged files never crash a reader: random bits, cuts and insertions, with fixed seeds. Run it in
// the sanitizer build for its full worth.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/open_scan_source.h"
#include "radive/util/random.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using testing::Floats;
using testing::TempFolder;

constexpr int kNumCases = 200;

// Below `bound`, or 0.
std::size_t Below(Random* random, std::size_t bound) {
  return bound == 0 ? 0 : static_cast<std::size_t>(random->Index(bound));
}

// One to three cuts, flipped bits, or insertions of a character that means something in a table.
std::string Damage(std::string content, Random* random) {
  constexpr char kMeaningful[] = "0123456789.,-+eE#\n\r \0nan";
  const std::size_t num_changes = 1 + Below(random, 3);
  for (std::size_t i = 0; i < num_changes; ++i) {
    const std::size_t place = Below(random, content.size());
    switch (Below(random, 3)) {
      case 0:
        content.resize(place);
        break;
      case 1:
        if (!content.empty()) content[place] ^= static_cast<char>(1 << Below(random, 8));
        break;
      default:
        content.insert(place, 1, kMeaningful[Below(random, sizeof(kMeaningful) - 1)]);
    }
  }
  return content;
}

// Opens the folder and reads it to the end. Whatever the files say, a source has the scans that it
// promised, none larger than the files allow; if it does not open, it says why.
void ReadDamaged(const TempFolder& folder, const InputOptions& options, std::size_t most_returns) {
  std::string error;
  const auto source = OpenScanSource(folder.string(), options, &error);
  if (source == nullptr) {
    EXPECT_NE(error.find(folder.string()), std::string::npos) << error;
    return;
  }
  const std::vector<RadarScan> scans = testing::ReadAll(source.get());
  EXPECT_EQ(source->NumScans(), static_cast<int>(scans.size()));
  for (const RadarScan& scan : scans) EXPECT_LE(scan.returns.size(), most_returns);
}

TEST(DamagedFiles, RawScansAndTimes) {
  const std::string scan = Floats({1, 2, 3, -4, 5, 6, 7, 8, -9, 10});
  const std::string times = "# stamps\n0.100000000\n0.2\n3.0e-1\n";
  InputOptions options;
  options.layout = "xyzdp5";
  Random random(1);
  for (int i = 0; i < kNumCases; ++i) {
    const TempFolder folder;
    for (const char* name : {"0.bin", "1.bin", "2.bin"}) folder.Write(name, Damage(scan, &random));
    folder.Write("times.txt", i % 2 == 0 ? times : Damage(times, &random));
    ReadDamaged(folder, options, 2);
  }
}

TEST(DamagedFiles, HerculesScans) {
  const std::string record = Floats({3, 4, 0, -10, 5}) + '\x80' + Floats({0.9, 0.0});
  InputOptions options;
  options.format = InputOptions::Format::kHercules;
  Random random(2);
  for (int i = 0; i < kNumCases; ++i) {
    const TempFolder folder;
    folder.Write("1693922345123456789.bin", Damage(record + record, &random));
    folder.Write("1693922345173456789.bin", record);
    ReadDamaged(folder, options, 2);
  }
}

TEST(DamagedFiles, RadarScenes) {
  const std::string table =
      "scan,timestamp_rad,first_point,num_points,timestamp_odom\n"
      "1,0.068314,0,2,0\n2,0.145249,2,1,0\n3,0.2,3,0,0\n";
  const std::string points = Floats({20, 0, -10, 5, 11, 10, 1, 2, -3, 0, 4, 3, 1.5, 0, 11});
  InputOptions options;
  options.format = InputOptions::Format::kRadarScenes;
  Random random(3);
  for (int i = 0; i < kNumCases; ++i) {
    const TempFolder folder;
    folder.Write("radar2_scans.csv", i % 3 == 0 ? table : Damage(table, &random));
    folder.Write("radar2_points.bin", i % 3 == 1 ? points : Damage(points, &random));
    ReadDamaged(folder, options, 3);
  }
}

}  // namespace
}  // namespace radive
