// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads the scans of a bag from a warm file: 400 of 7500 returns (an Oculii Eagle's), 60 MB.
// Bytes per second count the payloads before compression.

#include <benchmark/benchmark.h>
#include <glog/logging.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "radive/io/bags/bag_source.h"
#include "radive/io/bags/mcap_writer.h"
#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/bags/sqlite_bag_writer.h"
#include "radive/util/random.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

constexpr int kScans = 400;
constexpr int kReturns = 7500;

// Writes the drive and returns the size of its payloads [bytes].
std::int64_t WriteDrive(MessageWriter* writer, const std::string& encoding) {
  const std::string type =
      encoding == "ros1" ? "sensor_msgs/PointCloud2" : "sensor_msgs/msg/PointCloud2";
  const int topic = writer->AddTopic({"/radar", type, encoding, {}});
  Random random(42);
  RadarScan scan;
  scan.returns.resize(kReturns);
  std::int64_t num_bytes = 0;
  std::string error;
  for (int k = 0; k < kScans; ++k) {
    scan.stamp_ns = k * std::int64_t{66666667};
    for (RadarReturn& point : scan.returns) {
      point.position = {random.Uniform(0, 100), random.Uniform(-50, 50), random.Uniform(-2, 5)};
      point.doppler = random.Normal();
      point.power = random.Uniform(10, 40);
    }
    const std::string payload = EncodePointCloud2(scan, encoding, "radar");
    num_bytes += static_cast<std::int64_t>(payload.size());
    CHECK(writer->Write(topic, scan.stamp_ns, payload, &error)) << error;
  }
  CHECK(writer->Close(&error)) << error;
  return num_bytes;
}

void ReadDrive(benchmark::State& state, const std::string& path, BagFormat format) {
  for (auto _ : state) {
    std::string error;
    const auto source = BagSource::Open(path, format, InputOptions(), &error);
    CHECK(source != nullptr) << error;
    RadarScan scan;
    int num_scans = 0;
    while (source->Next(&scan) == ScanSource::Status::kScan) ++num_scans;
    CHECK_EQ(num_scans, kScans);
  }
}

void BM_ReadRos1Bag(benchmark::State& state) {
  const testing::ScratchFolder folder;
  const std::string path = (folder.path() / "drive.bag").string();
  const auto compression = static_cast<Compression>(state.range(0));
  std::string error;
  const auto writer = Ros1BagWriter::Create(path, {compression, true, 768 << 10}, &error);
  const std::int64_t num_bytes = WriteDrive(writer.get(), "ros1");
  ReadDrive(state, path, BagFormat::kRosbag1);
  state.SetBytesProcessed(state.iterations() * num_bytes);
  state.SetLabel(NameOf(compression));
}
BENCHMARK(BM_ReadRos1Bag)
    ->Arg(static_cast<int>(Compression::kNone))
    ->Arg(static_cast<int>(Compression::kLz4))
    ->Arg(static_cast<int>(Compression::kBz2))
    ->Unit(benchmark::kMillisecond);

void BM_ReadMcap(benchmark::State& state) {
  const testing::ScratchFolder folder;
  const std::string path = (folder.path() / "drive.mcap").string();
  const auto compression = static_cast<Compression>(state.range(0));
  std::string error;
  const auto writer = McapWriter::Create(path, {compression, true, 1 << 20}, &error);
  const std::int64_t num_bytes = WriteDrive(writer.get(), "cdr");
  ReadDrive(state, path, BagFormat::kMcap);
  state.SetBytesProcessed(state.iterations() * num_bytes);
  state.SetLabel(NameOf(compression));
}
BENCHMARK(BM_ReadMcap)
    ->Arg(static_cast<int>(Compression::kNone))
    ->Arg(static_cast<int>(Compression::kLz4))
    ->Arg(static_cast<int>(Compression::kZstd))
    ->Unit(benchmark::kMillisecond);

void BM_ReadSqliteBag(benchmark::State& state) {
  const testing::ScratchFolder folder;
  const std::string path = (folder.path() / "drive").string();
  std::string error;
  const auto writer = SqliteBagWriter::Create(path, {}, &error);
  const std::int64_t num_bytes = WriteDrive(writer.get(), "cdr");
  ReadDrive(state, path, BagFormat::kRosbag2);
  state.SetBytesProcessed(state.iterations() * num_bytes);
}
BENCHMARK(BM_ReadSqliteBag)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radive
