// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/quaternion_order.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace radive {
namespace {

constexpr double kStep = 1.0;  // between the poses that tell a direction [m]
constexpr int kFewestSteps = 8;
// Directions scatter by 1 - |their mean|. Those of the motion in the axes of the vehicle: so much
// tells that the rotations do not follow it, and they do where it is so much less. Those of the
// vehicle's vertical in the world: a ground vehicle stays upright, or upside down.
constexpr double kScatter = 0.02;
constexpr double kShareOfScatter = 0.2;
constexpr double kShareOfTilt = 0.5;

// How the rotations go with the motion.
class Directions {
 public:
  void Add(const Eigen::Quaterniond& q_world_body, const Eigen::Vector3d& step) {
    motion_ += q_world_body.conjugate() * step.normalized();
    vertical_ += q_world_body * Eigen::Vector3d::UnitZ();
    ++count_;
  }
  int count() const { return count_; }
  double MotionScatter() const { return 1.0 - motion_.norm() / count_; }
  double VerticalScatter() const { return 1.0 - vertical_.norm() / count_; }

 private:
  Eigen::Vector3d motion_ = Eigen::Vector3d::Zero();    // sum, axes of the body
  Eigen::Vector3d vertical_ = Eigen::Vector3d::Zero();  // sum, axes of the world
  int count_ = 0;
};

}  // namespace

bool HasScalarFirst(const RecordedTrajectory& poses) {
  Directions as_read, scalar_first;
  const MatrixPose* last = nullptr;
  for (const RecordedPose& pose : poses) {
    const MatrixPose& T = pose.T_world_body;
    if (last != nullptr) {
      const Eigen::Vector3d step = T.translation - last->translation;
      if (step.norm() < kStep) continue;
      const Eigen::Quaterniond q(last->rotation);
      as_read.Add(q, step);
      scalar_first.Add(Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()), step);
    }
    last = &T;
  }
  if (as_read.count() < kFewestSteps) return false;
  const double scatter = as_read.MotionScatter();
  return scatter > kScatter && scalar_first.MotionScatter() < kShareOfScatter * scatter &&
         scalar_first.VerticalScatter() < kShareOfTilt * as_read.VerticalScatter();
}

}  // namespace radive
