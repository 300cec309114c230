// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Bytes a second from a warm file to the returns of a scan.

#include <benchmark/benchmark.h>

#include <string>

#include "radive/io/open/open_scan_source.h"
#include "radive/io/open/open_scan_writer.h"
#include "radive/util/random.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

constexpr int kNumScans = 50;
constexpr int kNumReturns = 7000;

void BM_ReadDrive(benchmark::State& state, const std::string& format) {
  const testing::TempFolder folder;
  std::string error;
  const auto writer = OpenScanWriter(format, folder.path(), &error);
  Random random(42);
  RadarScan scan;
  for (int k = 0; k < kNumScans; ++k) {
    scan.stamp_ns = k * 100000000LL;
    scan.returns.resize(kNumReturns);
    for (RadarReturn& ret : scan.returns) {
      ret.position = {50 * random.Uniform(), 20 * random.Uniform(), random.Uniform()};
      ret.doppler = -10.0 * random.Uniform();
      ret.power = 20.0;
    }
    writer->Add(scan, &error);
  }
  writer->Finish(&error);
  std::int64_t size = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (entry.is_regular_file()) size += static_cast<std::int64_t>(entry.file_size());
  }
  InputOptions options;
  if (format == "raw") options.layout = "xyzdp5";
  for (auto _ : state) {
    const auto source = OpenScanSource(folder.string(), options, &error);
    if (source == nullptr) state.SkipWithError(error.c_str());
    while (source != nullptr && source->Next(&scan) == ScanSource::Status::kScan) {
      benchmark::DoNotOptimize(scan.returns.data());
    }
  }
  state.SetBytesProcessed(state.iterations() * size);
}
BENCHMARK_CAPTURE(BM_ReadDrive, raw, "raw")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, hercules, "hercules")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, pcd_binary, "pcd_binary")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, pcd_compressed, "pcd_compressed")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, pcd_ascii, "pcd_ascii")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, ply_binary, "ply_binary")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_ReadDrive, csv, "csv")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radive
