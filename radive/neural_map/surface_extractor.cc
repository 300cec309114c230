// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/surface_extractor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/sdf_query.h"

namespace radive {
namespace {

// Fewer neural points are no surface.
constexpr int kMinNeighbors = 3;

}  // namespace

std::vector<OptionField> SurfaceOptions::Fields() {
  return {
      {"criterion",
       MakeChoice(&criterion, {"sdf", "density"}),
       "-",
       "Points with a small |S|, or as many points of the largest support (for comparison)."},
      {"leave_out_self",
       &leave_out_self,
       "-",
       "S at a neural point comes from its neighbours alone, without the point itself."},
      OptionField{"threshold", &threshold, "m", "tau_s: surface points have |S| at most this."}
          .Above(0.0),
      OptionField{
          "min_support",
          &min_support,
          "-",
          "Least support of a surface point; one that one keyframe saw alone has 1 at most."}
          .AtLeast(0.0),
      OptionField{"trial_keyframes",
                  &trial_keyframes,
                  "-",
                  "Keyframes for which a new point is kept, whatever is known of it."}
          .AtLeast(0),
      OptionField{"projection",
                  &projection,
                  "-",
                  "Share of the way to the zero level set that points are moved."}
          .AtLeast(0.0)
          .AtMost(1.0),
      {"soft", &soft, "-", "Points lose weight with |S| and little support instead of being cut."},
  };
}

std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         bool leave_out_self) {
  std::vector<int> all(static_cast<std::size_t>(map.size()));
  std::iota(all.begin(), all.end(), 0);
  return EvaluatePoints(map, decoder, all, leave_out_self);
}

std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const std::vector<int>& indices,
                                         bool leave_out_self) {
  std::vector<SurfacePoint> result;
  result.reserve(indices.size());
  WithDecoderKernel(decoder, map.options().resolution, [&](const auto& kernel) {
    std::vector<NearPoint> near;
    for (const int k : indices) {
      const NeuralPoint& point = map.point(k);
      map.FindNear(point.position, &near);
      const SdfValue field = QuerySdf(map, kernel, point.position, near, leave_out_self ? k : -1);
      if (field.num_neighbors == 0) continue;
      SurfacePoint surface;
      surface.index = k;
      surface.position = point.position;
      surface.sdf = field.value;
      surface.age = map.last_keyframe() - point.created;
      if (field.num_neighbors >= kMinNeighbors) surface.support = map.Support(near);
      const double slope = field.gradient.norm();
      surface.normal = slope > 1e-6 ? Eigen::Vector3d(field.gradient / slope)
                                    : point.orientation.conjugate() * Eigen::Vector3d::UnitZ();
      result.push_back(surface);
    }
  });
  return result;
}

const std::vector<SurfacePoint>& SurfaceEvaluation::Update(const NeuralPoints& map,
                                                           const SdfDecoder& decoder,
                                                           bool leave_out_self) {
  if (parameters_ != decoder.parameters()) known_.clear();
  parameters_ = decoder.parameters();

  // Points keep their order, new ones come last.
  std::vector<int> changed;
  std::vector<const Known*> unchanged(static_cast<std::size_t>(map.size()), nullptr);
  auto known = known_.begin();
  for (int k = 0; k < map.size(); ++k) {
    const NeuralPoint& point = map.point(k);
    const auto same = std::find_if(known, known_.end(), [&point](const Known& entry) {
      return entry.cell == point.cell && entry.created == point.created;
    });
    if (same != known_.end()) known = std::next(same);
    if (same == known_.end() || point.last_change > version_) {
      changed.push_back(k);
    } else {
      unchanged[static_cast<std::size_t>(k)] = &*same;
    }
  }

  const std::vector<SurfacePoint> evaluated = EvaluatePoints(map, decoder, changed, leave_out_self);
  std::vector<SurfacePoint> points;
  std::vector<Known> now_known;
  auto next = evaluated.begin();
  for (int k = 0; k < map.size(); ++k) {
    const NeuralPoint& point = map.point(k);
    const Known* before = unchanged[static_cast<std::size_t>(k)];
    now_known.push_back({point.cell, point.created, -1});
    if (before == nullptr) {
      if (next == evaluated.end() || next->index != k) continue;
      points.push_back(*next++);
    } else {
      if (before->surface < 0) continue;
      points.push_back(points_[static_cast<std::size_t>(before->surface)]);
      points.back().index = k;
      points.back().age = map.last_keyframe() - point.created;
    }
    now_known.back().surface = static_cast<int>(points.size()) - 1;
  }
  points_ = std::move(points);
  known_ = std::move(now_known);
  version_ = map.version();
  return points_;
}

namespace {

bool IsOnSurface(const SurfacePoint& point, const SurfaceOptions& options) {
  return point.age < options.trial_keyframes ||
         (point.support >= options.min_support && std::abs(point.sdf) <= options.threshold);
}

// As many points as lie on a surface, those of the largest support.
std::vector<SurfacePoint> DensestPoints(std::vector<SurfacePoint> points,
                                        const SurfaceOptions& options) {
  const auto count = std::count_if(points.begin(), points.end(), [&](const SurfacePoint& point) {
    return IsOnSurface(point, options);
  });
  std::stable_sort(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.support > b.support;
  });
  points.resize(static_cast<std::size_t>(count));
  std::sort(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.index < b.index;
  });
  return points;
}

double SoftWeight(const SurfacePoint& point, const SurfaceOptions& options) {
  const bool has_sdf = options.criterion == SurfaceOptions::Criterion::kSdf;
  const double ratio = has_sdf ? point.sdf / options.threshold : 0.0;
  return std::exp(-0.5 * ratio * ratio) * point.support / (point.support + options.min_support);
}

}  // namespace

std::vector<SurfacePoint> SelectSurface(const std::vector<SurfacePoint>& points,
                                        const SurfaceOptions& options) {
  const bool has_sdf = options.criterion == SurfaceOptions::Criterion::kSdf;
  if (!has_sdf && !options.soft) return DensestPoints(points, options);
  std::vector<SurfacePoint> surface;
  for (SurfacePoint point : points) {
    if (options.soft) {
      point.weight = SoftWeight(point, options);
      if (!(point.weight > 0.0)) continue;
    } else if (!IsOnSurface(point, options)) {
      continue;
    }
    // A field that is further off than that does not know the point.
    if (has_sdf && std::abs(point.sdf) <= options.threshold) {
      point.position -= options.projection * point.sdf * point.normal;
    }
    surface.push_back(point);
  }
  return surface;
}

std::vector<SurfacePoint> ExtractSurface(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const SurfaceOptions& options) {
  return SelectSurface(EvaluatePoints(map, decoder, options.leave_out_self), options);
}

}  // namespace radive
