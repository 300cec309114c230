// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Damaged files never crash a reader: random bits, cuts and insertions, with fixed seeds. Run it in
// the sanitizer build for its full worth.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/open/open_scan_source.h"
#include "radive/io/points/point_file_writer.h"
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
// promised, none larger than the files allow; if it does not open, or none of its files can be
// read, it says why.
void ReadDamaged(const TempFolder& folder, const InputOptions& options, std::size_t most_returns) {
  std::string error;
  const auto source = OpenScanSource(folder.string(), options, &error);
  if (source == nullptr) {
    EXPECT_NE(error.find(folder.string()), std::string::npos) << error;
    return;
  }
  int num_scans = 0;
  RadarScan scan;
  ScanSource::Status status;
  while ((status = source->Next(&scan)) == ScanSource::Status::kScan) {
    ++num_scans;
    EXPECT_LE(scan.returns.size(), most_returns);
  }
  if (status == ScanSource::Status::kError) {  // none of the files can be read
    EXPECT_EQ(num_scans, 0);
    EXPECT_NE(source->error().find(folder.string()), std::string::npos) << source->error();
    return;
  }
  EXPECT_EQ(source->NumScans(), num_scans);
}

TEST(DamagedFiles, RawScansAndTimes) {
  const std::string scan = Floats({1, 2, 3, -4, 5, 6, 7, 8, -9, 10});
  const std::string times = "# stamps\n0.100000000\n0.2\n3.0e-1\n";
  InputOptions options;
  options.format = InputOptions::Format::kRaw;
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

// Reads the damaged files as drives of one scan each; whatever is in them, the returns fit into the
// file.
void ReadDamagedFiles(const std::string& name,
                      const std::string& content,
                      InputOptions::Format format,
                      std::uint64_t seed) {
  InputOptions options;
  options.format = format;
  Random random(seed);
  const auto read = [&](const std::string& bytes) {
    const TempFolder folder;
    folder.Write(name, bytes);
    ReadDamaged(folder, options, bytes.size());
  };
  for (std::size_t size = 0; size < content.size(); ++size) read(content.substr(0, size));
  for (int i = 0; i < kNumCases; ++i) read(Damage(content, &random));
  read("");
  read(std::string(100, '\xFF'));
}

std::vector<RadarReturn> Returns() {
  std::vector<RadarReturn> returns(3);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    returns[i].position = {10.0 + static_cast<double>(i), 2.5, -0.5};
    returns[i].doppler = -9.75;
    returns[i].power = 17.0;
  }
  return returns;
}

TEST(DamagedFiles, Pcd) {
  std::uint64_t seed = 4;
  for (const PcdEncoding encoding :
       {PcdEncoding::kAscii, PcdEncoding::kBinary, PcdEncoding::kCompressed}) {
    const std::string bytes = PcdBytes(Returns(), encoding);
    ReadDamagedFiles("0.pcd", bytes, InputOptions::Format::kPcd, seed++);
  }
}

TEST(DamagedFiles, Ply) {
  std::uint64_t seed = 7;
  for (const PlyEncoding encoding :
       {PlyEncoding::kAscii, PlyEncoding::kLittleEndian, PlyEncoding::kBigEndian}) {
    const std::string bytes = PlyBytes(Returns(), encoding);
    ReadDamagedFiles("0.ply", bytes, InputOptions::Format::kPly, seed++);
  }
}

TEST(DamagedFiles, Csv) {
  ReadDamagedFiles("0.csv", CsvBytes(Returns()), InputOptions::Format::kCsv, 10);
}

TEST(DamagedFiles, Npy) {
  const std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 5), }\n";
  const std::string bytes = std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) +
                            '\0' + header + RecordBytes(Returns(), KnownLayout("xyzdp5"));
  ReadDamagedFiles("0.npy", bytes, InputOptions::Format::kNpy, 11);
}

TEST(DamagedFiles, Yaml) {
  ReadDamagedFiles(
      "0.yaml",
      "sec: 1\ndetections:\n  - range: 10\n    azimuth_angle: 0.5\n    range_rate: -3\n"
      "  - range: 20\n    azimuth_angle: -0.5\n    range_rate: -4\nend: 1\n",
      InputOptions::Format::kYaml,
      13);
}

TEST(DamagedFiles, RaFlow) {
  const std::string scan =
      R"({"car_loc_x":[1,2],"car_loc_y":[3,4],"car_loc_z":[0,0],"car_vel_r":[-1,-1],)"
      R"("rcs":[5,6],"power":[7,8]})";
  const std::string bytes = "{\"pc1\":" + scan + ",\"pc2\":" + scan + ",\"interval\":0.1}";
  ReadDamagedFiles("radar_seqs-0_samples-1.json", bytes, InputOptions::Format::kRaFlow, 12);
}

}  // namespace
}  // namespace radive
