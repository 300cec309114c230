// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

#include "radive/geometry/pose_covariance.h"
#include "radive/geometry/rigid3.h"
#include "radive/geometry/twist.h"

namespace radive {

// The motion of a body as several radars on it tell it, each by an odometry of its own and at its
// own times, as one trajectory.
//
// Each radar says how the body moved between two of its scans. Where the times of several radars
// overlap, rotation and translation are their means, weighted by what each radar is worth: the
// variance that its registration has reported over the last minute and, for rotation, also that by
// which it has been seen to disagree with the others (Helmert's variance components). What all
// radars have seen is settled for good; from there to the newest scan those are averaged that have
// come so far. So each radar's word counts once, and its errors are averaged with the others' as
// independent ones are.
//
// On RadarScenes 105, where the best of four radars alone has 3.0 m: scans of all radars against
// one pose in turn pull at it (3.7 m, and 10.9 m with a common submap). Weights by each scan's own
// covariance favour what is wrong with confidence (4.5 m); full covariance matrices turn the
// lateral disagreement that mounting angles leave into yaw (6.4 m).
class MotionFusion {
 public:
  // Takes in that `radar` finds the body at `T_own_body` in a world frame of its own, which stays
  // the same for that radar, at `stamp_ns`: not before any stamp so far, and after the radar's
  // last. `covariance`: of the motion since its last scan, [rotation, translation] in its world
  // frame's axes [rad^2, rad m, m^2]. `velocity`: of the body at the scan, body frame [m/s], for
  // the time before any radar has a second scan.
  void Add(int radar,
           std::int64_t stamp_ns,
           const Rigid3& T_own_body,
           const Matrix6d& covariance,
           const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero());

  // The same at a scan whose pose is no measurement. Up to some of them in a row say nothing: the
  // radar's next step begins where it was last measured, else it would take back at full weight
  // what the prediction was wrong by.
  void AddPredicted(int radar,
                    std::int64_t stamp_ns,
                    const Rigid3& T_own_body,
                    const Matrix6d& covariance,
                    const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero());

  // At the last stamp; the world is the body's frame at the first one.
  const Rigid3& T_world_body() const { return T_world_body_; }
  // Of the motion in the time between two scans of the last radar, axes of the world frame.
  const Matrix6d& covariance() const { return covariance_; }

 private:
  // Between two scans of a radar.
  struct Step {
    std::int64_t begin_ns, end_ns;
    Twist rate;           // of the body, body frame [rad/s, m/s]
    Twist weight;         // of each component of the rate
    Matrix6d covariance;  // of the rate over one second
  };
  struct Chain {
    std::deque<Step> steps;  // those that are not settled, and the last
    std::int64_t stamp_ns = 0;
    Rigid3 T_own_body;
    std::int64_t usual_interval_ns = 0;  // 0: not known yet

    // Running means of the variance that registration reports, per second.
    double reported_time = 0.0;         // that they have been taken over, so far [s]
    double rotation_variance = 0.0;     // [rad^2/s]
    double translation_variance = 0.0;  // [m^2/s]

    // Rotation away from the mean of all radars, of late [rad], and the variance that it shows.
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
    double compared_time = 0.0;       // [s]
    double deviation_variance = 0.0;  // [rad^2/s]

    double RotationVariance() const;  // both together [rad^2/s]
  };
  struct MeanRate {
    Twist rate;
    Matrix6d covariance;  // over one second
  };

  static void AddStep(std::int64_t stamp_ns,
                      const Rigid3& T_own_body,
                      const Matrix6d& covariance,
                      Chain* chain);
  static MeanRate Mean(const std::vector<const Step*>& steps);
  static bool Covers(const Step& step, std::int64_t begin_ns, std::int64_t end_ns);
  static bool IsActive(const Chain& chain, std::int64_t stamp_ns);
  // Of the steps that cover all of the time from `begin_ns` to `end_ns`; without any, of the last
  // ones, which go on.
  MeanRate RateWithin(std::int64_t begin_ns, std::int64_t end_ns) const;
  // Of the last step of each radar; before there is any, by the velocity.
  MeanRate LastRate(std::int64_t stamp_ns) const;
  // From `begin_ns` to `end_ns`, without the first: the times at which a step begins or ends.
  std::set<std::int64_t> Breaks(std::int64_t begin_ns, std::int64_t end_ns) const;
  void SettleUntil(std::int64_t stamp_ns);
  // Places the body at `stamp_ns`.
  void MoveTo(std::int64_t stamp_ns, double interval, const Eigen::Vector3d& velocity);
  void Compare(std::int64_t begin_ns, std::int64_t end_ns);

  std::map<int, Chain> chains_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  // by the last scan, body frame [m/s]
  std::int64_t settled_ns_ = 0;
  Rigid3 T_world_settled_;
  Rigid3 T_world_body_;
  Matrix6d covariance_ = Matrix6d::Zero();
};

}  // namespace radive
