// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/simulation_options.h"

#include "radive/util/number_text.h"

namespace radive {
namespace {

OptionField Share(const char* name, double* share, const char* doc) {
  return OptionField{name, share, "-", doc}.AtLeast(0.0).AtMost(0.9);
}

}  // namespace

std::vector<OptionField> SimulationOptions::Fields() {
  return {
      OptionField{"sensor", MakeChoice(&sensor, SensorNames()), "", "Which sensor to simulate."},
      OptionField{"seed", &seed, "-", "Seed of the world, the traffic, the drive and all noise."}
          .AtLeast(0),
      OptionField{"frames", &frames, "-", "Number of scans."}.AtLeast(1).AtMost(1000000),
      OptionField{"rate", &rate, "Hz", "Scans per second; 0: the sensor's own rate."}
          .AtLeast(0.0)
          .AtMost(1000.0),
      OptionField{"returns", &returns, "-", "Mean returns of a scan; 0: the sensor's own number."}
          .AtLeast(0.0)
          .AtMost(200000.0),
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
      OptionField{"world", MakeChoice(&world, WorldNames()), "", "What stands around the lane."},
      OptionField{"vehicle", MakeChoice(&vehicle, VehicleNames()), "", "What the radar rides on."},
      OptionField{"max_speed", &max_speed, "m/s", "Highest speed of the car."}.AtLeast(0.5).AtMost(
          40.0),
      OptionField{"wobble", &wobble, "-", "Factor on how the vehicle rocks; 0: a smooth drive."}
          .AtLeast(0.0)
          .AtMost(10.0),
      OptionField{"stop_distance",
                  &stop_distance,
                  "m",
                  "Mean distance of the places where it stops; 0: once a lap."}
          .AtLeast(0.0),
      OptionField{"moving_cars", &moving_cars, "-", "Other cars on the loop."}.AtLeast(0).AtMost(
          40),
      OptionField{"lead_gap",
                  &lead_gap,
                  "m",
                  "From the rear axle to the middle of the vehicle ahead, standing."}
          .AtLeast(7.0)
          .AtMost(200.0),
      OptionField{"lead_headway", &lead_headway, "s", "What that distance grows by with speed."}
          .AtLeast(0.0)
          .AtMost(10.0),
      OptionField{"lead_is_truck", &lead_is_truck, "-", "The vehicle ahead is a truck."},
      Share("ghost_share", &ghost_share, "Share of multipath over walls and the own car."),
      Share("ground_ghost_share", &ground_ghost_share, "Share of multipath over the ground."),
      Share("clutter_share", &clutter_share, "Share of noise peaks and side lobes."),
      Share("duplicate_share", &duplicate_share, "Share of second returns behind the first."),
      OptionField{"ambiguity_scale",
                  &ambiguity_scale,
                  "-",
                  "Factor on the share of returns at a wrong elevation."}
          .AtLeast(0.0)
          .AtMost(10.0),
      OptionField{"noise_scale", &noise_scale, "-", "Factor on the noise of the sensor."}
          .AtLeast(0.0)
          .AtMost(10.0),
      OptionField{
          "outage_period", &outage_period, "s", "Time from one outage to the next; 0: none."}
          .AtLeast(0.0),
      OptionField{"outage_length", &outage_length, "s", "How long an outage lasts."}.AtLeast(0.0),
      Share("outage_returns",
            &outage_returns,
            "Share of the returns that is left in an outage; 0: no scan at all."),
  };
}

bool SimulationOptions::IsValid(std::string* error) const {
  if (!CheckOptions("simulation", *this, error)) return false;
  if (!(mount_position[2] > 0.0)) {
    *error = "simulation.mount_position must have z > 0 m (above ground), is " +
             NumberText(mount_position[2]);
    return false;
  }
  const double artefacts = ghost_share + ground_ghost_share + clutter_share + duplicate_share;
  if (!(artefacts < 0.95)) {
    *error =
        "simulation.ghost_share + ground_ghost_share + clutter_share + duplicate_share must be < "
        "0.95, is " +
        NumberText(artefacts);
    return false;
  }
  if (outage_period > 0.0 && !(outage_length < outage_period)) {
    *error = "simulation.outage_length must be < outage_period (" + NumberText(outage_period) +
             "), is " + NumberText(outage_length);
    return false;
  }
  return true;
}

SensorModel SimulationOptions::Sensor() const {
  SensorModel model = ModelOf(sensor);
  if (rate > 0.0) model.rate = rate;
  if (returns > 0.0) model.returns_per_scan = returns;
  model.ambiguous_share *= ambiguity_scale;
  model.sigma_range *= noise_scale;
  model.sigma_azimuth *= noise_scale;
  model.sigma_elevation *= noise_scale;
  model.sigma_doppler *= noise_scale;
  return model;
}

}  // namespace radive
