// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/neural_map/sdf_decoder.h"
#include "radive/neural_map/surface_options.h"

namespace radive {

// A neural point with what the field says of it.
struct SurfacePoint {
  int index = 0;                                       // of the neural point
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // map frame [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // unit, to the side the sensor saw
  double sdf = 0.0;                                    // S at the neural point [m]
  double support = 0.0;  // NeuralPoints::Support(); 0 with fewer than three neighbours [-]
  double weight = 1.0;   // trust, below 1 with soft limits [-]
  int age = 0;           // keyframes since it was first seen
};

// S of every neural point (normal of unit length; the point's own z axis where S is flat). Points
// whose field is not finite are left out. `leave_out_self`: see SurfaceOptions.
std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         bool leave_out_self = false);

// The same of the neural points `indices` alone.
std::vector<SurfacePoint> EvaluatePoints(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const std::vector<int>& indices,
                                         bool leave_out_self = false);

// EvaluatePoints() again and again, of a map that changes by keyframes and pruning: what lies where
// nothing has changed is kept from the last time.
class SurfaceEvaluation {
 public:
  // The same as EvaluatePoints(). The map and `leave_out_self` must be those of the last time.
  const std::vector<SurfacePoint>& Update(const NeuralPoints& map,
                                          const SdfDecoder& decoder,
                                          bool leave_out_self);

 private:
  struct Known {
    std::uint64_t cell;  // of the neural point
    int created;
    int surface;  // in points_; -1: left out
  };

  std::vector<SurfacePoint> points_;
  std::vector<Known> known_;        // all neural points
  std::vector<double> parameters_;  // of the decoder
  std::uint64_t version_ = 0;       // of the map
};

// Those of `points` that lie on a surface: |S| <= threshold (paper, eq. of P_surf) and support >=
// min_support, moved and weighted as `options` say, in the same order.
std::vector<SurfacePoint> SelectSurface(const std::vector<SurfacePoint>& points,
                                        const SurfaceOptions& options);

// SelectSurface() of all neural points.
std::vector<SurfacePoint> ExtractSurface(const NeuralPoints& map,
                                         const SdfDecoder& decoder,
                                         const SurfaceOptions& options);

}  // namespace radive
