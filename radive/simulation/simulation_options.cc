// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/simulation_options.h"

namespace radive {

std::vector<OptionField> SimulationOptions::Fields() {
  return {
      OptionField{"sensor",
                  MakeChoice(&sensor, {"oculii", "ars548", "planar2d"}),
                  "",
                  "Which radar to simulate."},
      OptionField{"seed", &seed, "-", "Seed of the street, the traffic, the drive and all noise."}
          .AtLeast(0),
      OptionField{"frames", &frames, "-", "Number of scans."}.AtLeast(1).AtMost(1000000),
      OptionField{"rate", &rate, "Hz", "Scans per second; 0: the sensor's own rate."}
          .AtLeast(0.0)
          .AtMost(1000.0),
      OptionField{
          "mount_position",
          &mount_position,
          "m",
          "Radar in the car frame: x ahead of the rear axle, y left, z above ground; within "
          "the car."}
          .Size(3)
          .AtLeast(-4.0)
          .AtMost(4.0),
      OptionField{"mount_yaw", &mount_yaw, "rad", "Direction of the radar, positive to the left."}
          .AtLeast(-3.15)
          .AtMost(3.15),
      OptionField{"max_speed", &max_speed, "m/s", "Highest speed of the car."}.AtLeast(0.5).AtMost(
          40.0),
      OptionField{"wobble", &wobble, "-", "Scale of pitch, roll and heave; 0: a plane drive."}
          .AtLeast(0.0)
          .AtMost(10.0),
      OptionField{"moving_cars", &moving_cars, "-", "Other cars on the loop."}.AtLeast(0).AtMost(
          40),
      OptionField{"ghost_share", &ghost_share, "-", "Share of multipath returns."}
          .AtLeast(0.0)
          .AtMost(0.9),
      OptionField{"clutter_share", &clutter_share, "-", "Share of noise peaks and side lobes."}
          .AtLeast(0.0)
          .AtMost(0.9),
      OptionField{
          "duplicate_share", &duplicate_share, "-", "Share of second returns behind the first."}
          .AtLeast(0.0)
          .AtMost(0.9),
      OptionField{"noise_scale", &noise_scale, "-", "Factor on the noise of the sensor."}
          .AtLeast(0.0)
          .AtMost(10.0),
  };
}

bool SimulationOptions::IsValid(std::string* error) const {
  if (!CheckOptions("simulation", *this, error)) return false;
  if (!(mount_position[2] > 0.0)) {
    *error = "simulation.mount_position must have z > 0 m (above ground), is " +
             std::to_string(mount_position[2]);
    return false;
  }
  const double artefacts = ghost_share + clutter_share + duplicate_share;
  if (!(artefacts < 0.95)) {
    *error = "simulation.ghost_share + clutter_share + duplicate_share must be < 0.95, is " +
             std::to_string(artefacts);
    return false;
  }
  return true;
}

SensorModel SimulationOptions::Sensor() const {
  SensorModel model = MakeSensorModel(sensor);
  if (rate > 0.0) model.rate = rate;
  model.sigma_range *= noise_scale;
  model.sigma_azimuth *= noise_scale;
  model.sigma_elevation *= noise_scale;
  model.sigma_doppler *= noise_scale;
  return model;
}

const std::vector<std::string>& ScenarioNames() {
  static const std::vector<std::string> names = {"street_dense", "street_sparse", "street_planar"};
  return names;
}

std::optional<SimulationOptions> ScenarioOptions(const std::string& name) {
  SimulationOptions options;
  if (name == "street_dense") return options;
  if (name == "street_sparse") {
    options.sensor = SensorType::kArs548;
    options.frames = 2400;
    return options;
  }
  if (name == "street_planar") {
    // A front corner radar that looks 25 degrees to the right.
    options.sensor = SensorType::kPlanar2d;
    options.frames = 1560;
    options.mount_position = {3.86, -0.7, 0.6};
    options.mount_yaw = -0.436;
    return options;
  }
  return std::nullopt;
}

}  // namespace radive
