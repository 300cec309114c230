// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The kernels by themselves, with the operations that they do a second: docs/performance.md
// compares them with what the processor can. state.range(0): place in AvailableKernels().

#include <benchmark/benchmark.h>

#include "benchmarks/registration/street_scene.h"
#include "radive/ego_velocity/displacement_votes.h"
#include "radive/ego_velocity/velocity_ransac.h"
#include "radive/factors/condensed_ndt_cost.h"
#include "tests/ego_velocity/made_returns.h"
#include "tests/with_kernels.h"

namespace radive {
namespace {

// Additions and multiplications; divisions, roots and comparisons count as one.
constexpr double kOperationsOfPair = 117.0;
constexpr double kOperationsOfCount = 8.0;   // of a return
constexpr double kOperationsOfGated = 42.0;  // of a return

const Kernels& KernelsOf(const benchmark::State& state) {
  const std::vector<const Kernels*> available = AvailableKernels();
  const auto place = static_cast<std::size_t>(state.range(0));
  return place < available.size() ? *available[place] : *available.back();
}

void CountOperations(benchmark::State& state, double number) {
  state.SetLabel(KernelsOf(state).name);
  state.counters["flops"] = benchmark::Counter(number * static_cast<double>(state.iterations()),
                                               benchmark::Counter::kIsRate);
}

void BM_SumNdtPairs(benchmark::State& state) {
  const testing::WithKernels with_kernels(KernelsOf(state));
  const StreetScene& scene = GetStreetScene(state.range(1) == 1);
  const std::vector<NdtPair> pairs =
      PairSearch(scene.submap).Find(scene.scan, scene.T_submap_radar, PairOptions(), 0.3);
  const CondensedNdtCost cost(scene.scan,
                              scene.submap,
                              pairs,
                              Eigen::Vector3d::Zero(),
                              NdtNormalisation::kUnit,
                              NdtDerivatives::kAnalytic);
  PoseBlock pose = ToPoseBlock(scene.T_submap_radar);
  for (auto _ : state) {
    pose[4] += 1e-9;  // at the same pose it is not computed again
    benchmark::DoNotOptimize(cost.Quadratic(pose.data()));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs.size()));
  CountOperations(state, kOperationsOfPair * static_cast<double>(pairs.size()));
}
BENCHMARK(BM_SumNdtPairs)->ArgNames({"kernels", "dense"})->ArgsProduct({{0, 1}, {0, 1}});

void BM_FindNear(benchmark::State& state) {
  const testing::WithKernels with_kernels(KernelsOf(state));
  const StreetScene& scene = GetStreetScene(state.range(1) == 1);
  const PairSearch search(scene.submap);
  const std::vector<double> max_variances = LargestVariances(scene.scan);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        search.Find(scene.scan, max_variances, scene.T_submap_radar, PairOptions(), 0.3));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.scan.size()));
  state.SetLabel(KernelsOf(state).name);
}
BENCHMARK(BM_FindNear)->ArgNames({"kernels", "dense"})->ArgsProduct({{0, 1}, {0, 1}});

DopplerEquations Equations() {
  Random random(1);
  const testing::ReturnsModel model;
  return MakeDopplerEquations(testing::MakeStaticReturns(7000, {12.0, 0.3, -0.1}, model, &random),
                              {0.0, 0.0, 1.0});
}

void BM_CountWithinGate(benchmark::State& state) {
  const Kernels& kernels = KernelsOf(state);
  const DopplerEquations equations = Equations();
  const DopplerColumns columns = equations.Columns();
  const double velocity[] = {12.0, 0.3, -0.1};
  for (auto _ : state) {
    benchmark::DoNotOptimize(kernels.count_within_gate(columns, velocity, 0.3));
  }
  state.SetItemsProcessed(state.iterations() * columns.size);
  state.SetBytesProcessed(state.iterations() * columns.size * 4 * 8);
  CountOperations(state, kOperationsOfCount * columns.size);
}
BENCHMARK(BM_CountWithinGate)->ArgName("kernels")->Arg(0)->Arg(1);

void BM_SumWithinGate(benchmark::State& state) {
  const Kernels& kernels = KernelsOf(state);
  const DopplerEquations equations = Equations();
  const Eigen::ArrayXd weights = Eigen::ArrayXd::Ones(equations.size());
  const DopplerColumns columns = equations.Columns(&weights);
  const DopplerGate gate = {{12.0, 0.3, -0.1}, 0.3, 0.1};
  std::vector<unsigned char> inliers(static_cast<std::size_t>(columns.size + 3) / 4);
  DopplerSums sums;
  for (auto _ : state) {
    kernels.sum_within_gate(columns, gate, /*with_rest=*/false, &sums, inliers.data());
    benchmark::DoNotOptimize(sums.equations);
  }
  state.SetItemsProcessed(state.iterations() * columns.size);
  state.SetBytesProcessed(state.iterations() * columns.size * 5 * 8);
  CountOperations(state, kOperationsOfGated * columns.size);
}
BENCHMARK(BM_SumWithinGate)->ArgName("kernels")->Arg(0)->Arg(1);

// Two scans of 300 points in a square of 60 m, 11 turns.
void BM_DisplacementVotes(benchmark::State& state) {
  const testing::WithKernels with_kernels(KernelsOf(state));
  Random random(1);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 2000; ++i) {
    points.emplace_back(random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0));
  }
  const VotingPoints voting = MakeVotingPoints(points, 300);
  for (auto _ : state) benchmark::DoNotOptimize(DisplacementVotes(voting, voting, 0.1));
  state.SetItemsProcessed(state.iterations() * 11);
  state.SetLabel(KernelsOf(state).name);
}
BENCHMARK(BM_DisplacementVotes)->ArgName("kernels")->Arg(0)->Arg(1);

}  // namespace
}  // namespace radive
