// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/scenarios.h"

#include <utility>

namespace radive {
namespace {

constexpr double kDuration = 120.0;  // [s]

using Named = std::pair<const char*, SimulationOptions>;

// What differs from the street.
std::vector<Named> Places() {
  const SimulationOptions street;
  SimulationOptions avenue = street;
  avenue.world = WorldType::kAvenue;
  avenue.max_speed = 18.0;
  avenue.moving_cars = 3;
  avenue.lead_gap = 60.0;

  SimulationOptions campus = street;
  campus.world = WorldType::kCampus;
  campus.max_speed = 7.0;
  campus.moving_cars = 2;

  SimulationOptions car_park = street;
  car_park.world = WorldType::kCarPark;
  car_park.max_speed = 4.0;
  car_park.moving_cars = 1;

  SimulationOptions tunnel = street;
  tunnel.world = WorldType::kTunnel;
  tunnel.moving_cars = 0;
  tunnel.ghost_share = 0.08;

  SimulationOptions stop_and_go = street;
  stop_and_go.max_speed = 6.0;
  stop_and_go.stop_distance = 30.0;
  stop_and_go.moving_cars = 20;
  stop_and_go.lead_gap = 12.0;
  stop_and_go.lead_headway = 0.4;
  stop_and_go.lead_is_truck = true;

  SimulationOptions handcart = car_park;
  handcart.vehicle = VehicleType::kHandcart;
  handcart.max_speed = 1.4;
  handcart.moving_cars = 0;
  handcart.mount_position = {0.4, 0.0, 0.8};

  SimulationOptions outages = street;
  outages.outage_period = 15.0;
  outages.outage_length = 2.0;

  return {{"street", street},
          {"avenue", avenue},
          {"campus", campus},
          {"car_park", car_park},
          {"tunnel", tunnel},
          {"stop_and_go", stop_and_go},
          {"handcart", handcart},
          {"outages", outages}};
}

constexpr std::pair<const char*, SensorType> kSensors[] = {{"dense", SensorType::kOculii},
                                                           {"sparse", SensorType::kArs548},
                                                           {"planar", SensorType::kPlanar2d},
                                                           {"aeva", SensorType::kAeva}};

std::vector<std::pair<std::string, SimulationOptions>> AllScenarios() {
  std::vector<std::pair<std::string, SimulationOptions>> scenarios;
  for (const auto& [place, place_options] : Places()) {
    for (const auto& [suffix, sensor] : kSensors) {
      SimulationOptions options = place_options;
      options.sensor = sensor;
      options.frames = static_cast<int>(kDuration * ModelOf(sensor).rate);
      if (sensor == SensorType::kPlanar2d && options.vehicle == VehicleType::kCar) {
        // A front corner radar that looks 25 degrees to the right.
        options.mount_position = {3.86, -0.7, 0.6};
        options.mount_yaw = -0.436;
      }
      scenarios.emplace_back(std::string(place) + "_" + suffix, options);
    }
  }
  return scenarios;
}

const std::vector<std::pair<std::string, SimulationOptions>>& Scenarios() {
  static const auto scenarios = AllScenarios();
  return scenarios;
}

}  // namespace

const std::vector<std::string>& ScenarioNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, options] : Scenarios()) all.push_back(name);
    return all;
  }();
  return names;
}

std::optional<SimulationOptions> ScenarioOptions(const std::string& name) {
  for (const auto& [known, options] : Scenarios()) {
    if (known == name) return options;
  }
  return std::nullopt;
}

}  // namespace radive
