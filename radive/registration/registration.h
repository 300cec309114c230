// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/registration/registration_options.h"
#include "radive/registration/registration_result.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// What is known of the pose before the scan is looked at. Each becomes a factor; all poses and
// points are in the submap frame.
struct RegistrationPriors {
  struct Translation {
    Eigen::Vector3d t_submap_radar;  // [m]
    Eigen::Matrix3d covariance;      // [m^2]
  };
  struct Displacement {
    Rigid3 T_submap_radar0;        // the previous pose
    Eigen::Vector3d displacement;  // chord in the radar frame half-way [m]
    Eigen::Matrix3d covariance;    // [m^2]
  };
  struct Rotation {
    Eigen::Quaterniond q_submap_radar;
    Eigen::Matrix3d covariance;  // of the rotation vector in the submap frame [rad^2]
  };
  struct AttitudeHeight {
    Eigen::Vector3d up_radar;     // the vehicle's up axis in the radar frame
    Eigen::Vector3d up_submap;    // where it should point
    Eigen::Vector3d t_reference;  // a point at the height that is expected [m]
    double sigma_angle;           // [rad]
    double sigma_height;          // [m]
  };
  struct NoSlip {
    Rigid3 T_submap_radar0;  // the previous pose
    Rigid3 T_e_radar;        // e: frame of the point that does not slip
    double lateral_offset;   // [m]
    double sigma;            // [m]
  };

  std::optional<Translation> translation;
  std::optional<Displacement> displacement;
  std::optional<Rotation> rotation;
  std::optional<AttitudeHeight> attitude_height;
  std::optional<NoSlip> no_slip;

  // Set: the pose may only move in the plane with this normal (submap frame).
  std::optional<Eigen::Vector3d> plane_normal;
};

// A scan, what it is to be aligned with, and what is known beforehand. Nothing is copied: all that
// is pointed to must outlive it.
struct RegistrationInput {
  const std::vector<Gaussian3>* scan = nullptr;  // radar frame
  const PairSearch* search = nullptr;            // over the submap's Gaussians
  Rigid3 T_prediction;                           // first guess of T_submap_radar
  double slack = 0.5;      // error of the prediction that the pair search allows for [m]
  bool is_planar = false;  // the sensor measures no elevation
  RegistrationPriors priors;

  // The range rates of the scan, for doppler_icp.
  struct Doppler {
    const std::vector<RadarReturn>* returns = nullptr;  // static ones
    const std::vector<double>* weights = nullptr;       // one a return [-]
    Rigid3 T_submap_radar0;                             // the previous pose
    double dt = 0.0;                                    // since then, > 0 [s]
    double sigma = 0.1;                                 // of the range rates [m/s]
  };
  std::optional<Doppler> doppler;
};

// Aligns a scan with a submap by options.method and the priors. Stateless.
RegistrationResult Register(const RegistrationInput& input,
                            const PairOptions& pair_options,
                            const RegistrationOptions& options);

// The same from what NDT needs.
RegistrationResult RegisterNdt(const std::vector<Gaussian3>& scan,
                               const PairSearch& search,
                               const Rigid3& T_prediction,
                               double slack,
                               const RegistrationPriors& priors,
                               const PairOptions& pair_options,
                               const RegistrationOptions& options);

}  // namespace radive
