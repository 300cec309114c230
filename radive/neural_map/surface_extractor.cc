// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/surface_extractor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/sdf_query.h"

namespace radive {

std::vector<OptionField> SurfaceOptions::Fields() {
  return {
      {"criterion",
       MakeChoice(&criterion, {"sdf", "density"}),
       "-",
       "Points with a small |S|, or as many points of the largest support (for comparison)."},
      OptionField{"threshold", &threshold, "m", "tau_s: surface points have |S| at most this."}
          .Above(0.0),
      OptionField{"min_support",
                  &min_support,
                  "-",
                  "Least certainty of a surface point and its neighbours, in keyframes."}
          .AtLeast(0.0),
      OptionField{"projection",
                  &projection,
                  "-",
                  "Share of the way to the zero level set that points are moved."}
          .AtLeast(0.0)
          .AtMost(1.0),
      {"soft", &soft, "-", "Points lose weight with |S| instead of being cut at the threshold."},
  };
}

std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map, const SdfDecoder& decoder) {
  std::vector<int> all(static_cast<std::size_t>(map.size()));
  std::iota(all.begin(), all.end(), 0);
  return EvaluatePoints(map, decoder, all);
}

std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const std::vector<int>& indices) {
  std::vector<SurfacePoint> result;
  result.reserve(indices.size());
  WithDecoderKernel(decoder, map.options().resolution, [&](const auto& kernel) {
    for (const int k : indices) {
      const NeuralPoint& point = map.point(k);
      const SdfValue field = QuerySdf(map, kernel, point.position);
      if (field.num_neighbors == 0) continue;
      SurfacePoint surface;
      surface.index = k;
      surface.position = point.position;
      surface.sdf = field.value;
      surface.support = field.support;
      const double slope = field.gradient.norm();
      surface.normal = slope > 1e-6 ? Eigen::Vector3d(field.gradient / slope)
                                    : point.orientation.conjugate() * Eigen::Vector3d::UnitZ();
      result.push_back(surface);
    }
  });
  return result;
}

namespace {

// As many points as pass the threshold, those of the largest support.
std::vector<SurfacePoint> DensestPoints(std::vector<SurfacePoint> points,
                                        const SurfaceOptions& options) {
  const auto count = std::count_if(points.begin(), points.end(), [&](const SurfacePoint& point) {
    return point.support >= options.min_support && std::abs(point.sdf) <= options.threshold;
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

}  // namespace

std::vector<SurfacePoint> SelectSurface(const std::vector<SurfacePoint>& points,
                                        const SurfaceOptions& options) {
  if (options.criterion == SurfaceOptions::Criterion::kDensity) {
    return DensestPoints(points, options);
  }
  std::vector<SurfacePoint> surface;
  for (SurfacePoint point : points) {
    if (!(point.support >= options.min_support)) continue;
    if (!options.soft && !(std::abs(point.sdf) <= options.threshold)) continue;
    const double ratio = point.sdf / options.threshold;
    point.weight = options.soft ? std::exp(-0.5 * ratio * ratio) : 1.0;
    point.position -= options.projection * point.sdf * point.normal;
    surface.push_back(point);
  }
  return surface;
}

std::vector<SurfacePoint> ExtractSurface(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const SurfaceOptions& options) {
  return SelectSurface(EvaluatePoints(map, decoder), options);
}

}  // namespace radive
