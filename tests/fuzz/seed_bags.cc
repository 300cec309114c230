// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes small bags for the fuzz targets to start from: seed_bags FOLDER.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "radive/io/bags/mcap_writer.h"
#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/bags/sqlite_bag_writer.h"
#include "radive/io/bytes/compression.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

RadarScan MadeScan(int k) {
  RadarScan scan;
  scan.stamp_ns = k * std::int64_t{100000000};
  for (int i = 0; i < 3; ++i) {
    RadarReturn& added = scan.returns.emplace_back();
    added.position = {10.0 + i, i - 1.0, 0.5 * k};
    added.doppler = -i;
    added.power = 20.0;
  }
  return scan;
}

// Three scans in the chunks of a bag.
void WriteScans(std::unique_ptr<MessageWriter> writer, const std::string& encoding) {
  const std::string type =
      encoding == "ros1" ? "sensor_msgs/PointCloud2" : "sensor_msgs/msg/PointCloud2";
  const int topic = writer->AddTopic({"/radar", type, encoding, {}});
  const int other = writer->AddTopic({"/imu", "a/Imu", encoding, {}});
  std::string error;
  for (int k = 0; k < 3; ++k) {
    const RadarScan scan = MadeScan(k);
    writer->Write(topic, scan.stamp_ns, EncodePointCloud2(scan, encoding, "radar"), &error);
    writer->Write(other, scan.stamp_ns + 1, "imu", &error);
  }
  writer->Close(&error);
}

std::string Content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void WriteText(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void WriteSeeds(const fs::path& folder) {
  for (const char* name : {"fuzz_ros1_bag",
                           "fuzz_mcap",
                           "fuzz_sqlite_bag",
                           "fuzz_rosbag2_metadata",
                           "fuzz_point_cloud",
                           "fuzz_compression"}) {
    fs::create_directories(folder / name);
  }
  std::string error;
  for (const bool index : {true, false}) {
    for (int i = 0; i < 4; ++i) {
      const auto compression = static_cast<Compression>(i);
      const std::string name = std::string(NameOf(compression)) + (index ? "" : "_unindexed");
      if (compression != Compression::kZstd) {
        const fs::path path = folder / "fuzz_ros1_bag" / name;
        WriteScans(Ros1BagWriter::Create(path, {compression, index, 300}, &error), "ros1");
      }
      if (compression != Compression::kBz2) {
        const fs::path path = folder / "fuzz_mcap" / name;
        WriteScans(McapWriter::Create(path, {compression, index, 300}, &error), "cdr");
      }
      WriteText(
          folder / "fuzz_compression" / NameOf(compression),
          std::string{static_cast<char>(i), 10} + Compress(compression, std::string(1024, 'a')));
    }
  }
  for (const bool packed : {false, true}) {
    const fs::path bag = folder / (packed ? "bag_packed" : "bag");
    WriteScans(SqliteBagWriter::Create(bag, {packed}, &error), "cdr");
    const std::string name = bag.filename().string();
    WriteText(folder / "fuzz_sqlite_bag" / name, Content(bag / (name + "_0.db3")));
    WriteText(folder / "fuzz_rosbag2_metadata" / name, Content(bag / "metadata.yaml"));
    fs::remove_all(bag);
  }
  const fs::path clouds = folder / "fuzz_point_cloud";
  WriteText(clouds / "ros1", std::string(1, '\0') + EncodePointCloud2(MadeScan(1), "ros1", "r"));
  WriteText(clouds / "cdr", std::string(1, '\1') + EncodePointCloud2(MadeScan(1), "cdr", "r"));
  // A PointCloud with one point and one channel.
  std::string named(1, '\2');
  named += std::string(16, '\0') + std::string("\1\0\0\0", 4) + std::string(12, '\0') +
           std::string("\1\0\0\0\7\0\0\0Doppler\1\0\0\0", 19) + std::string(4, '\0');
  WriteText(clouds / "channels", named);
}

}  // namespace
}  // namespace radive

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "seed_bags FOLDER\n");
    return 1;
  }
  radive::WriteSeeds(argv[1]);
  return 0;
}
