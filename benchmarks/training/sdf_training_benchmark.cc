// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "radive/factors/sdf_fit_factor.h"
#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/surface_extractor.h"
#include "radive/sensor/radar_noise_model.h"
#include "radive/simulation/radar_simulator.h"
#include "radive/training/sdf_mapper.h"

namespace radive {
namespace {

// Keyframes every 2 m of a simulated street at the true poses, traffic left out, up to 60 m.
std::vector<MapKeyframe> MakeKeyframes(bool dense) {
  SimulationOptions simulation = ScenarioOptions(dense ? "street_dense" : "street_sparse").value();
  simulation.seed = 3;
  RadarSimulator simulator(simulation);
  RadarScan scan;
  GroundTruth truth;
  std::vector<MapKeyframe> keyframes;
  while (keyframes.size() < 12 && simulator.Next(&scan, &truth)) {
    const Rigid3& T_world_radar = truth.T_world_radar;
    if (!keyframes.empty() && (T_world_radar.translation - keyframes.back().origin).norm() < 2.0) {
      continue;
    }
    MapKeyframe keyframe;
    keyframe.origin = T_world_radar.translation;
    const Eigen::Matrix3d R = T_world_radar.RotationMatrix();
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      const Eigen::Vector3d& p_radar = scan.returns[i].position;
      if (truth.labels[i] == ReturnLabel::kMoving || p_radar.norm() > 60.0) continue;
      MapReturn entry;
      entry.position = T_world_radar * p_radar;
      entry.covariance = R * PositionCovariance(p_radar, SensorOptions(), false) * R.transpose();
      keyframe.returns.push_back(entry);
    }
    keyframes.push_back(std::move(keyframe));
  }
  return keyframes;
}

const std::vector<MapKeyframe>& Keyframes(bool dense) {
  static const std::vector<MapKeyframe> keyframes[] = {MakeKeyframes(false), MakeKeyframes(true)};
  return keyframes[dense ? 1 : 0];
}

// One keyframe into a map of eleven: search, labels, training. Counters: samples, and the label rms
// of six held-out samples a point [m].
void TimeKeyframe(const std::vector<MapKeyframe>& keyframes,
                  const NeuralMapOptions& map_options,
                  const SdfTrainingOptions& options,
                  benchmark::State& state) {
  SdfTrainingOptions held_out = options;
  held_out.samples_per_point = 6;
  for (auto _ : state) {
    state.PauseTiming();
    auto mapper = std::make_unique<SdfMapper>(map_options, options);
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k) mapper->AddKeyframe(keyframes[k]);
    state.ResumeTiming();
    const TrainingResult result = mapper->AddKeyframe(keyframes.back());
    state.PauseTiming();
    state.counters["samples"] = result.num_samples;
    state.counters["rms_m"] =
        LabelRms(mapper->HeldOutSamples(held_out), mapper->map(), mapper->decoder());
    mapper.reset();
    state.ResumeTiming();
  }
}
// range(0): dense; range(1): samples a point; range(2): SdfTrainingOptions::Label.
void BM_Keyframe(benchmark::State& state) {
  SdfTrainingOptions options;
  options.samples_per_point = static_cast<int>(state.range(1));
  options.label = static_cast<SdfTrainingOptions::Label>(state.range(2));
  TimeKeyframe(Keyframes(state.range(0) != 0), NeuralMapOptions(), options, state);
}
constexpr int kPlane = static_cast<int>(SdfTrainingOptions::Label::kPlane);
constexpr int kSmooth = static_cast<int>(SdfTrainingOptions::Label::kSmooth);
BENCHMARK(BM_Keyframe)
    ->Args({1, 2, kSmooth})
    ->Args({1, 2, kPlane})
    ->Args({1, 6, kPlane})
    ->Args({0, 2, kSmooth})
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

// Dense, in the set-up that a prototype of the method had: plane labels, features of 8 numbers, 32
// hidden units, neural points at the first return, six samples a point, four steps, no prior.
void BM_KeyframeOfThePrototype(benchmark::State& state) {
  NeuralMapOptions map;
  map.feature_dim = 8;
  map.position = NeuralMapOptions::Position::kFirst;
  map.softening = 0.05;
  map.noise_scale = 1000.0;
  SdfTrainingOptions options;
  options.label = SdfTrainingOptions::Label::kPlane;
  options.samples_per_point = 6;
  options.feature_prior_sigma = 0.0;
  options.solver.max_iterations = 4;
  TimeKeyframe(Keyframes(true), map, options, state);
}
BENCHMARK(BM_KeyframeOfThePrototype)->Iterations(5)->Unit(benchmark::kMillisecond);

// A map of twelve keyframes and samples to train the last of them.
struct Lesson {
  Lesson() : mapper(NeuralMapOptions(), SdfTrainingOptions()) {
    for (const MapKeyframe& keyframe : Keyframes(true)) mapper.AddKeyframe(keyframe);
    samples = mapper.HeldOutSamples(SdfTrainingOptions());
    for (int k = 0; k < mapper.map().size(); ++k) {
      if (mapper.map().point(k).last_update + 1 == static_cast<int>(Keyframes(true).size())) {
        free.push_back(k);
      }
    }
  }

  SdfMapper mapper;
  std::vector<SdfSample> samples;
  std::vector<int> free;
};

const Lesson& DenseLesson() {
  static const Lesson lesson;
  return lesson;
}

// Problem and one Levenberg-Marquardt step; range(0): SolverOptions::LinearSolver.
void BM_Iteration(benchmark::State& state) {
  const Lesson& lesson = DenseLesson();
  SdfTrainingOptions options;
  options.solver.max_iterations = 1;
  options.solver.linear_solver = static_cast<SolverOptions::LinearSolver>(state.range(0));
  NeuralPoints map = lesson.mapper.map();
  for (auto _ : state) {
    TrainFeatures(lesson.samples, lesson.free, lesson.mapper.decoder(), options, &map);
  }
}
BENCHMARK(BM_Iteration)
    ->Arg(static_cast<int>(SolverOptions::LinearSolver::kCgnr))
    ->Arg(static_cast<int>(SolverOptions::LinearSolver::kIterativeSchur))
    ->Arg(static_cast<int>(SolverOptions::LinearSolver::kSparseNormalCholesky))
    ->Unit(benchmark::kMillisecond);

// One sample of six neighbours with derivatives: the public functor by autodiff, and what the
// kernel needs for the same.
void BM_FactorAutodiff(benchmark::State& state) {
  const SdfDecoder decoder = NeuralMapOptions().Decoder();
  const std::vector<SdfNeighbor> neighbors(6, {{0.2, -0.1, 0.3}, 1.0 / 6.0});
  const std::unique_ptr<ceres::CostFunction> cost(
      SdfFitFactor::Create(decoder, 0.5, neighbors, 0.1, 0.2));
  const double feature[4] = {0.1, 0.2, -0.1, 0.3};
  std::vector<const double*> blocks(6, feature);
  blocks.push_back(decoder.parameters().data());
  double residual = 0.0, entries[6][4];
  double* jacobians[] = {
      entries[0], entries[1], entries[2], entries[3], entries[4], entries[5], nullptr};
  for (auto _ : state) {
    cost->Evaluate(blocks.data(), &residual, jacobians);
    benchmark::DoNotOptimize(entries);
  }
}
BENCHMARK(BM_FactorAutodiff);

void BM_FactorKernel(benchmark::State& state) {
  const SdfDecoder decoder = NeuralMapOptions().Decoder();
  const DecoderKernel<4, 16> kernel(decoder, 0.5);
  const double feature[4] = {0.1, 0.2, -0.1, 0.3};
  const auto part = kernel.Feature(feature);
  Eigen::Vector4d gradient;
  for (auto _ : state) {
    for (int k = 0; k < 6; ++k) {
      benchmark::DoNotOptimize(kernel.Derivatives(part, {0.2, -0.1, 0.3}, &gradient, nullptr));
      benchmark::DoNotOptimize(gradient);
    }
  }
}
BENCHMARK(BM_FactorKernel);

void BM_ExtractSurface(benchmark::State& state) {
  const Lesson& lesson = DenseLesson();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        ExtractSurface(lesson.mapper.map(), lesson.mapper.decoder(), SurfaceOptions()));
  }
  state.SetItemsProcessed(state.iterations() * lesson.mapper.map().size());
}
BENCHMARK(BM_ExtractSurface)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radive
