// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>
#include <ceres/problem.h>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/factors/condensed_doppler_factor.h"
#include "radive/factors/doppler_factor.h"
#include "radive/solver/solve.h"
#include "tests/ego_velocity/made_returns.h"

namespace radive {
namespace {

const Eigen::Vector3d kVelocity(12.0, 0.3, -0.1);

// Four in five returns are static, the others belong to a car that drives ahead.
std::vector<RadarReturn> Scan(int num_returns, double half_elevation) {
  Random random(42);
  testing::ReturnsModel model;
  model.half_elevation = half_elevation;
  auto returns = testing::MakeStaticReturns(num_returns * 4 / 5, kVelocity, model, &random);
  const auto car =
      testing::MakeReturns(num_returns / 5, kVelocity, {9.0, 0.0, 0.0}, model, &random);
  returns.insert(returns.end(), car.begin(), car.end());
  return returns;
}

// What odometry does for one scan: RANSAC, refinement and covariance.
void EstimateScan(benchmark::State& state, double half_elevation) {
  const auto returns = Scan(static_cast<int>(state.range(0)), half_elevation);
  EgoVelocityEstimator estimator({}, {});
  std::int64_t stamp_ns = 0;
  for (auto _ : state) {
    const EgoVelocity velocity = estimator.Estimate(returns, half_elevation == 0.0, stamp_ns);
    stamp_ns += 75'000'000;
    benchmark::DoNotOptimize(velocity.v_radar.data());
    if (!velocity.valid) state.SkipWithError(velocity.reason.c_str());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void BM_EgoVelocityDense(benchmark::State& state) { EstimateScan(state, 0.2); }
BENCHMARK(BM_EgoVelocityDense)->Arg(7000)->Unit(benchmark::kMicrosecond);

void BM_EgoVelocityPlanar(benchmark::State& state) { EstimateScan(state, 0.0); }
BENCHMARK(BM_EgoVelocityPlanar)->Arg(226)->Unit(benchmark::kMicrosecond);

// The least squares of one round, as one block for each return ...
void BM_BlockForEachReturn(benchmark::State& state) {
  const auto returns = Scan(static_cast<int>(state.range(0)), 0.2);
  for (auto _ : state) {
    Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();
    ceres::Problem problem;
    for (const RadarReturn& entry : returns) {
      problem.AddResidualBlock(
          DopplerFactor::Create(entry.position.normalized(), entry.doppler, 0.1),
          nullptr,
          v_radar.data());
    }
    Solve(SolverOptions(), &problem);
    benchmark::DoNotOptimize(v_radar.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_BlockForEachReturn)->Arg(226)->Arg(7000)->Unit(benchmark::kMicrosecond);

// ... and as one block for all.
void BM_CondensedBlock(benchmark::State& state) {
  const auto returns = Scan(static_cast<int>(state.range(0)), 0.2);
  for (auto _ : state) {
    Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();
    CondensedDopplerFactor::Sum sum;
    for (const RadarReturn& entry : returns) {
      sum.Add(entry.position.normalized(), entry.doppler, 0.1);
    }
    ceres::Problem problem;
    problem.AddResidualBlock(CondensedDopplerFactor::Create(sum), nullptr, v_radar.data());
    Solve(SolverOptions(), &problem);
    benchmark::DoNotOptimize(v_radar.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_CondensedBlock)->Arg(226)->Arg(7000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace radive
