// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include "radive/preprocessing/preprocess.h"
#include "tests/ego_velocity/made_returns.h"

namespace radive {
namespace {

RadarScan Scan(int num_returns) {
  Random random(42);
  RadarScan scan;
  scan.has_doppler = true;
  scan.returns =
      testing::MakeStaticReturns(num_returns, {12.0, 0.3, -0.1}, testing::ReturnsModel(), &random);
  return scan;
}

void RunPreprocess(benchmark::State& state,
                   const SensorOptions& sensor,
                   const PreprocessingOptions& options) {
  const RadarScan scan = Scan(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const auto returns = Preprocess(scan, sensor, options, nullptr);
    benchmark::DoNotOptimize(returns.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void BM_Gate(benchmark::State& state) { RunPreprocess(state, {}, {}); }
BENCHMARK(BM_Gate)->Arg(226)->Arg(7000)->Unit(benchmark::kMicrosecond);

void BM_CorrectAndGate(benchmark::State& state) {
  SensorOptions sensor;
  sensor.azimuth_scale = 0.96;
  RunPreprocess(state, sensor, {});
}
BENCHMARK(BM_CorrectAndGate)->Arg(226)->Arg(7000)->Unit(benchmark::kMicrosecond);

void BM_AzimuthBins(benchmark::State& state) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kQuantised;
  RunPreprocess(state, {}, options);
}
BENCHMARK(BM_AzimuthBins)->Arg(226)->Arg(7000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace radive
