// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/output_frame.h"

#include "radive/geometry/pose_covariance.h"

namespace radive {

OutputFrame::OutputFrame(const RunConfig& config, int first_radar) {
  using Frame = OutputOptions::Frame;
  const Rigid3 T_vehicle_radar = config.odometry.sensor.ForRadar(first_radar).T_vehicle_radar();
  const bool body_is_vehicle = config.odometry.motion.body == MotionOptions::Body::kVehicle;
  const bool on_vehicle = config.reference.mounted_on == ReferenceOptions::MountedOn::kVehicle;
  const Rigid3 T_mount_reference = config.reference.T_mount_reference();
  const Rigid3 T_vehicle_body = body_is_vehicle ? Rigid3() : T_vehicle_radar;
  const Rigid3 T_vehicle_reference =
      on_vehicle ? T_mount_reference : T_vehicle_radar * T_mount_reference;
  Rigid3 T_vehicle_output = T_vehicle_body;
  switch (config.output.frame) {
    case Frame::kBody:
      is_body_ = true;
      break;
    case Frame::kRadar:
      T_vehicle_output = T_vehicle_radar;
      is_body_ = !body_is_vehicle;
      break;
    case Frame::kVehicle:
      T_vehicle_output = Rigid3();
      is_body_ = body_is_vehicle;
      break;
    case Frame::kReference:
      T_vehicle_output = T_vehicle_reference;
      break;
  }
  T_body_output_ = T_vehicle_body.Inverse() * T_vehicle_output;
  is_body_ = is_body_ || IsIdentity(T_body_output_);
  // Of the radar itself, not even rounding comes between.
  const bool is_same =
      !on_vehicle && config.reference.mount.empty() && is_body_ && !body_is_vehicle;
  if (!is_same) T_output_reference_ = T_vehicle_output.Inverse() * T_vehicle_reference;
}

void OutputFrame::Apply(OdometryResult* result) const {
  if (is_body_) return;
  const Rigid3 T_output_body = T_body_output_.Inverse();
  const Eigen::Vector3d lever = result->T_world_body.rotation * T_body_output_.translation;
  result->covariance = TurnedCovariance(T_output_body.RotationMatrix(),
                                        CovarianceAtLever(result->covariance, lever));
  result->T_world_body = T_output_body * result->T_world_body * T_body_output_;
  result->T_world_radar = T_output_body * result->T_world_radar;
  for (Eigen::Vector3d& point : result->keyframe_points) point = T_output_body * point;
}

void OutputFrame::Apply(RadarSurface* surface) const {
  if (!is_body_) surface->T_world_map = T_body_output_.Inverse() * surface->T_world_map;
}

}  // namespace radive
