// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/sensor/sensor_options.h"

#include "radive/geometry/roll_pitch_yaw.h"

namespace radive {
namespace {

constexpr double kHalfTurn = 3.1416;  // a little more than pi, so that rounded settings pass

constexpr std::size_t kMountColumns = 7;

}  // namespace

Rigid3 SensorOptions::T_vehicle_radar() const {
  return {RotationFromRollPitchYaw(mount_roll, mount_pitch, mount_yaw),
          Eigen::Vector3d(mount_x, mount_y, mount_z)};
}

SensorOptions SensorOptions::ForRadar(int radar) const {
  SensorOptions options = *this;
  for (std::size_t row = 0; row + kMountColumns <= mounts.size(); row += kMountColumns) {
    if (static_cast<int>(mounts[row]) != radar) continue;
    options.mount_x = mounts[row + 1];
    options.mount_y = mounts[row + 2];
    options.mount_z = mounts[row + 3];
    options.mount_roll = mounts[row + 4];
    options.mount_pitch = mounts[row + 5];
    options.mount_yaw = mounts[row + 6];
  }
  return options;
}

std::vector<OptionField> SensorOptions::Fields() {
  return {
      OptionField{"sigma_range", &sigma_range, "m", "Standard deviation of the range."}.Above(0.0),
      OptionField{"sigma_azimuth", &sigma_azimuth, "rad", "Standard deviation of the azimuth."}
          .Above(0.0),
      OptionField{
          "sigma_elevation", &sigma_elevation, "rad", "Standard deviation of the elevation."}
          .Above(0.0),
      OptionField{"sigma_doppler", &sigma_doppler, "m/s", "Standard deviation of the range rate."}
          .Above(0.0),
      OptionField{"doppler_span",
                  &doppler_span,
                  "m/s",
                  "The Doppler is known but for multiples of this, as it wraps at half of it to "
                  "either side; 0: it does not."}
          .AtLeast(0.0),
      OptionField{"range_scale", &range_scale, "-", "Factor on measured ranges."}.Above(0.0).AtMost(
          2.0),
      OptionField{"azimuth_scale", &azimuth_scale, "-", "Factor on measured azimuths."}
          .Above(0.0)
          .AtMost(2.0),
      OptionField{"azimuth_offset",
                  &azimuth_offset,
                  "rad",
                  "Added to the azimuth after its factor; positive to the left."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"mount_x", &mount_x, "m", "Radar ahead of the rear axle."},
      OptionField{"mount_y", &mount_y, "m", "Radar to the left of the rear axle's middle."},
      OptionField{"mount_z", &mount_z, "m", "Radar above the rear axle."},
      OptionField{"mount_roll", &mount_roll, "rad", "Roll of the radar in the vehicle."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"mount_pitch",
                  &mount_pitch,
                  "rad",
                  "Pitch of the radar in the vehicle; positive looks down."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"mount_yaw",
                  &mount_yaw,
                  "rad",
                  "Direction of the radar in the vehicle; positive looks to the left."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"mounts",
                  &mounts,
                  "m, rad",
                  "Mounts of several radars, which win over mount_*: for each its number, x, y, z, "
                  "roll, pitch, yaw."},
  };
}

bool SensorOptions::IsValid(std::string* error) const {
  if (!CheckOptions("sensor", *this, error)) return false;
  if (mounts.size() % kMountColumns != 0) {
    *error = "sensor.mounts must be rows of " + std::to_string(kMountColumns) + " numbers, has " +
             std::to_string(mounts.size());
    return false;
  }
  return true;
}

}  // namespace radive
