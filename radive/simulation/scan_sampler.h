// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "radive/sensor/radar_scan.h"
#include "radive/simulation/ground_truth.h"
#include "radive/simulation/radar_world.h"
#include "radive/simulation/sensor_model.h"
#include "radive/simulation/simulation_options.h"
#include "radive/util/random.h"

namespace radive {

// Draws the returns of single scans: what a sensor sees of a world from a pose.
//
// Real returns come from exact rays, drawn from the beam pattern and kept with the probability that
// the surface answers (Material), and from repeatable scatterers in view. A static return has the
// Doppler -d . v_radar of its true direction d. Artefacts derive from real returns of the same
// scan. Each return is measured with the sensor's noise.
class ScanSampler {
 public:
  // `options` must be valid. `world` must outlive this object.
  ScanSampler(const SimulationOptions& options, const RadarWorld& world);

  // Appends to `scan->returns`, and to the entries per return of `truth`, whose pose and velocity
  // are given. `share` of the usual number of returns [-]. `cars`: the moving ones.
  void Draw(const std::vector<MovingCar>& cars,
            double share,
            std::uint64_t seed,
            RadarScan* scan,
            GroundTruth* truth) const;

  const SensorModel& sensor() const { return sensor_; }

 private:
  // A return before noise, or a scatterer that may become one.
  struct Echo {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // radar frame [m]
    double doppler = 0.0;                                // [m/s]
    ReturnLabel label = ReturnLabel::kStatic;
    double penetration = 0.0;  // of its surface [m], see Material
    // Errors of range, azimuth and elevation in standard deviations.
    Eigen::Vector3d errors = Eigen::Vector3d::Zero();
    bool has_errors = false;  // given already
  };
  // A wall that was hit, as a mirror; radar frame.
  struct Mirror {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit, towards the radar
  };
  struct View;  // everything that holds for one scan

  void FindVisibleScatterers(View* view) const;
  void AddIfVisible(const Scatterer& scatterer,
                    const Eigen::Vector3d& velocity,
                    ReturnLabel label,
                    View* view) const;
  bool DrawReturn(View* view, Echo* echo, RadarReturn* measured) const;
  bool DrawSurface(View* view, Echo* echo) const;
  bool DrawScatterer(View* view, Echo* echo) const;
  bool DrawGhost(View* view, Echo* echo) const;
  bool DrawGroundGhost(View* view, Echo* echo) const;
  bool DrawClutter(View* view, Echo* echo) const;
  bool DrawDuplicate(View* view, Echo* echo) const;
  Eigen::Vector3d ErrorsLike(const Eigen::Vector3d& errors, Random* random) const;
  void ConfuseElevation(View* view, Echo* echo, RadarReturn* measured) const;
  bool Measure(Random* random, Echo* echo, RadarReturn* measured) const;
  double DetectionProbability(double range, double reach) const;

  const SimulationOptions options_;
  const SensorModel sensor_;
  const RadarWorld& world_;
};

}  // namespace radive
