// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Registration and its parts on a scan of the simulated street. state.range(0): 0 sparse, 1 dense.

#include <benchmark/benchmark.h>
#include <ceres/problem.h>

#include "benchmarks/registration/street_scene.h"
#include "radive/factors/condensed_ndt_cost.h"
#include "radive/factors/ndt_pair_factor.h"
#include "radive/geometry/pose_manifold.h"
#include "radive/registration/registration.h"
#include "radive/solver/solve.h"

namespace radive {
namespace {

// Dense scans: more pairs a voxel, so that the benchmark has the 16 thousand of the design notes.
PairOptions Pairs(bool dense) {
  PairOptions options;
  if (dense) {
    options.max_mahalanobis = 14.0;
    options.max_neighbors = 16;
  }
  return options;
}

// 0.2 m and 0.5 degrees beside the truth.
Rigid3 Prediction(const StreetScene& scene) {
  return {QuaternionFromRotationVector({0.0, 0.0, 0.009}) * scene.T_submap_radar.rotation,
          scene.T_submap_radar.translation + Eigen::Vector3d(0.15, -0.12, 0.02)};
}

std::vector<NdtPair> FindPairs(bool dense) {
  const StreetScene& scene = GetStreetScene(dense);
  return PairSearch(scene.submap).Find(scene.scan, Prediction(scene), Pairs(dense), 0.3);
}

void BM_VoxelsOfDenseScan(benchmark::State& state) {
  const StreetScene& scene = GetStreetScene(true);
  const std::vector<double> weights(scene.points.size(), 1.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(GaussiansOfVoxels(scene.points, weights, NdtOptions()));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.points.size()));
}
BENCHMARK(BM_VoxelsOfDenseScan)->Unit(benchmark::kMicrosecond);

void BM_BuildPairSearch(benchmark::State& state) {
  const StreetScene& scene = GetStreetScene(state.range(0) == 1);
  for (auto _ : state) {
    const PairSearch search(scene.submap);
    benchmark::DoNotOptimize(&search);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.submap.size()));
}
BENCHMARK(BM_BuildPairSearch)->ArgName("dense")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void BM_FindPairs(benchmark::State& state) {
  const bool dense = state.range(0) == 1;
  const StreetScene& scene = GetStreetScene(dense);
  const PairSearch search(scene.submap);
  std::size_t num_pairs = 0;
  for (auto _ : state) {
    num_pairs = search.Find(scene.scan, Prediction(scene), Pairs(dense), 0.3).size();
  }
  state.counters["pairs"] = static_cast<double>(num_pairs);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.scan.size()));
}
BENCHMARK(BM_FindPairs)->ArgName("dense")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void EvaluateCondensed(benchmark::State& state, NdtDerivatives derivatives) {
  const bool dense = state.range(0) == 1;
  const StreetScene& scene = GetStreetScene(dense);
  const std::vector<NdtPair> pairs = FindPairs(dense);
  const CondensedNdtCost cost(scene.scan,
                              scene.submap,
                              pairs,
                              Eigen::Vector3d::Zero(),
                              NdtNormalisation::kUnit,
                              derivatives);
  PoseBlock pose = ToPoseBlock(Prediction(scene));
  const double* blocks[] = {pose.data()};
  double residuals[7], jacobian[49];
  double* jacobians[] = {jacobian};
  for (auto _ : state) {
    pose[4] += 1e-9;  // at the same pose it is not computed again
    benchmark::DoNotOptimize(cost.Evaluate(blocks, residuals, jacobians));
    benchmark::DoNotOptimize(residuals[6]);
  }
  state.counters["pairs"] = static_cast<double>(pairs.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs.size()));
}

void BM_CondensedAnalytic(benchmark::State& state) {
  EvaluateCondensed(state, NdtDerivatives::kAnalytic);
}
BENCHMARK(BM_CondensedAnalytic)->ArgName("dense")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void BM_CondensedAutodiff(benchmark::State& state) {
  EvaluateCondensed(state, NdtDerivatives::kAutodiff);
}
BENCHMARK(BM_CondensedAutodiff)->ArgName("dense")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

// Builds the problem and takes five steps, with one block for each pair or one for all.
void SolveFiveSteps(benchmark::State& state, bool condensed) {
  const bool dense = state.range(0) == 1;
  const StreetScene& scene = GetStreetScene(dense);
  const std::vector<NdtPair> pairs = FindPairs(dense);
  SolverOptions options;
  options.max_iterations = 5;
  options.function_tolerance = 1e-16;
  options.parameter_tolerance = 1e-16;
  for (auto _ : state) {
    PoseBlock pose = ToPoseBlock(Prediction(scene));
    ceres::Problem::Options problem_options;
    problem_options.disable_all_safety_checks = true;
    ceres::Problem problem(problem_options);
    problem.AddParameterBlock(pose.data(), 7, new PoseManifold);
    if (condensed) {
      problem.AddResidualBlock(new CondensedNdtCost(scene.scan,
                                                    scene.submap,
                                                    pairs,
                                                    Eigen::Vector3d::Zero(),
                                                    NdtNormalisation::kUnit,
                                                    NdtDerivatives::kAnalytic),
                               nullptr,
                               pose.data());
    } else {
      for (const NdtPair& pair : pairs) {
        const Gaussian3& a = scene.scan[static_cast<std::size_t>(pair.scan)];
        const Gaussian3& b = scene.submap[static_cast<std::size_t>(pair.submap)];
        problem.AddResidualBlock(NdtPairFactor::Create(a, b, NdtNormalisation::kUnit),
                                 new NdtPairLoss(a.weight),
                                 pose.data());
      }
    }
    benchmark::DoNotOptimize(Solve(options, &problem));
  }
  state.counters["pairs"] = static_cast<double>(pairs.size());
}

void BM_FiveStepsOneBlockForAll(benchmark::State& state) { SolveFiveSteps(state, true); }
BENCHMARK(BM_FiveStepsOneBlockForAll)
    ->ArgName("dense")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

void BM_FiveStepsOneBlockForEachPair(benchmark::State& state) { SolveFiveSteps(state, false); }
BENCHMARK(BM_FiveStepsOneBlockForEachPair)
    ->ArgName("dense")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

// As odometry calls it, in the plane. range(1): RegistrationMethod.
void BM_Register(benchmark::State& state) {
  const bool dense = state.range(0) == 1;
  const StreetScene& scene = GetStreetScene(dense);
  const PairSearch search(scene.submap);
  const std::vector<double> weights(scene.returns.size(), 1.0);
  RegistrationOptions options;
  options.method = static_cast<RegistrationMethod>(state.range(1));
  RegistrationInput input;
  input.scan = &scene.scan;
  input.search = &search;
  input.T_prediction = Prediction(scene);
  input.slack = 0.3;
  input.priors.plane_normal = Eigen::Vector3d::UnitZ();
  input.doppler = {&scene.returns, &weights, scene.T_submap_radar0, scene.dt, 0.1};
  RegistrationResult result;
  for (auto _ : state) result = Register(input, Pairs(dense), options);
  if (!result.converged) state.SkipWithError(result.message.c_str());
  for (const OptionField& field : options.Fields()) {
    if (field.name == "method") state.SetLabel(field.ToString());
  }
  state.counters["pairs"] = result.num_pairs;
  state.counters["steps"] = result.num_iterations;
  state.counters["error_cm"] =
      100.0 *
      (result.T_submap_radar.translation - scene.T_submap_radar.translation).head<2>().norm();
}
BENCHMARK(BM_Register)
    ->ArgNames({"dense", "method"})
    ->ArgsProduct({{0, 1}, {0, 1, 2, 3, 4, 5}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radive
