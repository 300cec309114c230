// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/decoder_lessons.h"

#include <algorithm>
#include <deque>

#include "radive/simulation/radar_simulator.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr int kKeyframes = 24;
constexpr double kKeyframeDistance = 2.0;  // [m]
constexpr double kDriveOffset = 5000.0;    // between the drives in the map [m]
constexpr double kMaxRange = 60.0;         // [m]
constexpr int kLessonEvery = 3;            // keyframes
constexpr std::size_t kOwnersPerLesson = 100;

struct DriveLesson {
  const char* scenario;
  int seed;
};

// The points of `seen` nearest to one of them: as in a training, samples then outnumber features.
std::vector<int> Region(const NeuralPoints& map, const std::vector<int>& seen, Random* random) {
  if (seen.empty()) return {};
  const Eigen::Vector3d center = map.point(seen[random->Index(seen.size())]).position;
  std::vector<int> region = seen;
  std::sort(region.begin(), region.end(), [&](int a, int b) {
    const double d_a = (map.point(a).position - center).squaredNorm();
    const double d_b = (map.point(b).position - center).squaredNorm();
    return d_a < d_b || (d_a == d_b && a < b);
  });
  region.resize(std::min(region.size(), kOwnersPerLesson));
  return region;
}

// One drive into the lessons; `first_index` numbers its keyframes on from the drives before.
void AddDrive(const DriveLesson& drive,
              int first_index,
              const SdfTrainingOptions& training,
              DecoderLessons* lessons) {
  SimulationOptions simulation = ScenarioOptions(drive.scenario).value();
  simulation.seed = drive.seed;
  const Eigen::Vector3d offset(kDriveOffset * first_index / kKeyframes, 0.0, 0.0);
  RadarSimulator simulator(simulation);
  Random random(static_cast<std::uint64_t>(drive.seed));
  std::deque<LabelScan> scans;
  RadarScan scan;
  GroundTruth truth;
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e9);
  for (int index = first_index;
       index < first_index + kKeyframes && simulator.Next(&scan, &truth);) {
    const Rigid3& T_world_radar = truth.T_world_radar;
    if ((T_world_radar.translation - last).norm() < kKeyframeDistance) continue;
    last = T_world_radar.translation;
    LabelScan label_scan;
    const Eigen::Vector3d label_scan_origin = last + offset;
    label_scan.origin = label_scan_origin;
    std::vector<MapReturn> returns;
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      // Without noise: a decoder of noisy labels learns to mistrust the local planes, and then does
      // not know a clean one. Features can still say how far to go.
      const Eigen::Vector3d& p_radar = truth.noise_free_positions[i];
      if (truth.labels[i] != ReturnLabel::kStatic || p_radar.norm() > kMaxRange) continue;
      MapReturn entry;
      entry.position = T_world_radar * p_radar + offset;
      returns.push_back(entry);
      label_scan.points.push_back(entry.position);
    }
    label_scan.weights.assign(label_scan.points.size(), 1.0);
    scans.push_back(std::move(label_scan));
    while (static_cast<int>(scans.size()) > training.label_window) scans.pop_front();
    std::vector<const LabelScan*> window;
    for (const LabelScan& entry : scans) window.push_back(&entry);
    const std::vector<int> seen = lessons->map.AddKeyframe(returns, index, label_scan_origin);
    const SdfLabels labels(window, lessons->map, training);
    InitialisePoints(&lessons->map, seen, labels, index);
    if (++index % kLessonEvery == 0) {
      for (const SdfSample& sample : DrawSamples(
               lessons->map, Region(lessons->map, seen, &random), labels, index, training)) {
        lessons->samples.push_back(sample);
      }
    }
  }
}

}  // namespace

DecoderLessons MakeDecoderLessons(const NeuralMapOptions& map_options,
                                  const SdfTrainingOptions& training,
                                  int seed) {
  DecoderLessons lessons = {NeuralPoints(map_options), {}};
  const DriveLesson drives[] = {
      {"street_dense", 100 + seed}, {"street_sparse", 200 + seed}, {"street_dense", 300 + seed}};
  int first_index = 0;
  for (const DriveLesson& drive : drives) {
    AddDrive(drive, first_index, training, &lessons);
    first_index += kKeyframes;
  }
  // Points have moved and neighbours have appeared since the samples were drawn.
  for (SdfSample& sample : lessons.samples) {
    sample.neighbors = lessons.map.Nearest(sample.position);
  }
  return lessons;
}

}  // namespace radive
