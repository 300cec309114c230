// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/reference_options.h"

#include "radive/geometry/roll_pitch_yaw.h"

namespace radive {

const std::vector<std::string>& ReferenceFormatNames() {
  static const std::vector<std::string>* const names = new std::vector<std::string>{"auto",
                                                                                    "tum",
                                                                                    "kitti",
                                                                                    "euroc",
                                                                                    "table",
                                                                                    "vod",
                                                                                    "radarscenes",
                                                                                    "coloradar",
                                                                                    "boreas",
                                                                                    "dicp",
                                                                                    "raflow",
                                                                                    "bag"};
  return *names;
}

Rigid3 ReferenceOptions::T_mount_reference() const {
  if (mount.empty()) return Rigid3();
  return {RotationFromRollPitchYaw(mount[3], mount[4], mount[5]),
          Eigen::Vector3d(mount[0], mount[1], mount[2])};
}

std::vector<OptionField> ReferenceOptions::Fields() {
  return {
      {"format",
       MakeChoice(&format, ReferenceFormatNames()),
       "-",
       "Form of the ground truth that --reference names; auto finds it out."},
      {"topic", &topic, "-", "Topic of a bag with the poses; empty: the only one that has any."},
      {"mounted_on",
       MakeChoice(&mounted_on, {"radar", "vehicle"}),
       "-",
       "What reference.mount is relative to: the radar (of the first scan), or the vehicle."},
      {"mount",
       &mount,
       "m, rad",
       "Where the body of the ground truth sits: x, y, z, roll, pitch, yaw; empty: its poses are "
       "those of the radar, or of the vehicle."},
      OptionField{"max_time_difference",
                  &max_time_difference,
                  "s",
                  "Largest difference of the stamps of poses that belong together."}
          .AtLeast(0.0),
      {"interpolate",
       &interpolate,
       "-",
       "Bring the ground truth to the stamps of the scans instead."},
      OptionField{
          "max_gap", &max_gap, "s", "Longest interval of the ground truth to interpolate in."}
          .Above(0.0),
  };
}

bool ReferenceOptions::IsValid(std::string* error) const {
  if (!CheckOptions("reference", *this, error)) return false;
  if (mount.empty() || mount.size() == 6) return true;
  *error = "reference.mount must be x, y, z, roll, pitch, yaw or empty, has " +
           std::to_string(mount.size()) + " numbers";
  return false;
}

}  // namespace radive
