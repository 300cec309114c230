// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "radive/kernels/doppler_columns.h"
#include "radive/sensor/radar_scan.h"
#include "radive/util/random.h"

namespace radive {

// The Doppler of a scan as linear equations in the velocity of the radar, v_doppler = -d . v, for
// the returns that have a direction and a Doppler. The horizontal part of a direction is its first
// two coordinates in `basis`.
struct DopplerEquations {
  Eigen::ArrayXd x, y, z;        // unit directions in the radar frame
  Eigen::ArrayXd first, second;  // their coordinates along the columns of `basis`
  Eigen::ArrayXd v_doppler;      // [m/s]
  Eigen::ArrayXd range;          // [m]
  Eigen::Matrix<double, 3, 2> basis = Eigen::Matrix<double, 3, 2>::Zero();
  double span = 0.0;  // v_doppler is known but for multiples of this [m/s]; 0: known

  int size() const { return static_cast<int>(v_doppler.size()); }
  Eigen::Vector3d Direction(Eigen::Index i) const { return {x[i], y[i], z[i]}; }

  // As the kernels take them; `weights` must outlive what is returned.
  DopplerColumns Columns(const Eigen::ArrayXd* weights = nullptr) const {
    return {{x.data(), y.data(), z.data()},
            v_doppler.data(),
            weights == nullptr ? nullptr : weights->data(),
            size(),
            span};
  }

  // v_doppler + d . v of all returns [m/s], of the multiple of the span nearest to v.
  Eigen::ArrayXd Residuals(const Eigen::Vector3d& v_radar) const {
    Eigen::ArrayXd residuals = v_doppler + x * v_radar.x() + y * v_radar.y() + z * v_radar.z();
    if (span > 0.0) residuals -= span * (residuals / span).round();
    return residuals;
  }
};

// `up_radar`: unit vector along the vertical of the vehicle, in the radar frame.
DopplerEquations MakeDopplerEquations(const std::vector<RadarReturn>& returns,
                                      const Eigen::Vector3d& up_radar,
                                      double span = 0.0);

// A limit on the horizontal part of a velocity, as coordinates in the basis of the equations.
struct VelocityGate {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // [m/s]
  double radius = 0.0;                               // [m/s]

  bool Contains(const Eigen::Vector2d& velocity) const {
    return (velocity - center).norm() <= radius;
  }
};

struct VelocityHypothesis {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // in the basis of the equations [m/s]
  int num_inliers = 0;
};

// The horizontal velocity that most returns agree with, by RANSAC: `num_draws` hypotheses from two
// returns each, which count the returns within `gate` [m/s] of them. Two returns and no vertical
// velocity, because samples of three are ill-conditioned at the elevations of radars. Hypotheses
// outside the temporal gate do not count; its center is a hypothesis itself. None when no draw
// gives one.
std::optional<VelocityHypothesis> DrawVelocity(const DopplerEquations& equations,
                                               double gate,
                                               int num_draws,
                                               const std::optional<VelocityGate>& temporal_gate,
                                               Random* random);

// The same in three dimensions, from three returns a hypothesis (paper, "Dynamic point filtering
// via RANSAC and ego-velocity"): the velocity of the radar in its own frame [m/s]. The temporal
// gate limits the horizontal part.
std::optional<Eigen::Vector3d> DrawSpatialVelocity(const DopplerEquations& equations,
                                                   double gate,
                                                   int num_draws,
                                                   const std::optional<VelocityGate>& temporal_gate,
                                                   Random* random);

}  // namespace radive
