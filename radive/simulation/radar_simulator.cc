// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/radar_simulator.h"

#include <glog/logging.h>

#include <cmath>
#include <string>

#include "radive/simulation/world_builder.h"

namespace radive {
namespace {

std::uint64_t SeedOf(int seed, std::uint64_t purpose) {
  return Random(static_cast<std::uint64_t>(seed) * 0x100000001B3ull + purpose).Bits();
}

const SimulationOptions& Checked(const SimulationOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  return options;
}

StreetPath PathOf(const WorldStyle& style) {
  return {style.long_side, style.short_side, style.corner};
}

Traffic::Options TrafficOf(const SimulationOptions& options) {
  Traffic::Options traffic;
  traffic.num_cars = options.moving_cars;
  traffic.lead_gap = options.lead_gap;
  traffic.lead_headway = options.lead_headway;
  traffic.lead_is_truck = options.lead_is_truck;
  return traffic;
}

VehicleMotion::Options MotionOf(const SimulationOptions& options) {
  VehicleMotion::Options motion;
  motion.style = StyleOf(options.vehicle);
  motion.max_speed = options.max_speed;
  motion.wobble = options.wobble;
  motion.stop_distance = options.stop_distance;
  return motion;
}

}  // namespace

RadarSimulator::RadarSimulator(const SimulationOptions& options)
    : options_(Checked(options)),
      path_(PathOf(StyleOf(options.world))),
      world_(BuildWorld(path_, StyleOf(options.world), SeedOf(options.seed, 1))),
      sampler_(options, world_),
      traffic_(path_, world_.terrain(), TrafficOf(options), SeedOf(options.seed, 2)),
      motion_(path_, world_.terrain(), MotionOf(options), SeedOf(options.seed, 3)),
      T_body_radar_(
          Eigen::Quaterniond(Eigen::AngleAxisd(options.mount_yaw, Eigen::Vector3d::UnitZ())),
          Eigen::Vector3d(
              options.mount_position[0], options.mount_position[1], options.mount_position[2])) {}

std::int64_t RadarSimulator::StampOf(int k) const {
  return std::llround(static_cast<double>(k) * 1e9 / sensor().rate);
}

double RadarSimulator::TravelledAt(std::int64_t stamp_ns) {
  return motion_.TravelAt(static_cast<double>(stamp_ns) * 1e-9).s;
}

// The first period is left whole, so that a drive never begins with an outage.
double RadarSimulator::ShareOfReturns(double time) const {
  if (options_.outage_period <= 0.0 || time < options_.outage_period) return 1.0;
  const bool is_out = std::fmod(time, options_.outage_period) < options_.outage_length;
  return is_out ? options_.outage_returns : 1.0;
}

bool RadarSimulator::Next(RadarScan* scan, GroundTruth* truth) {
  while (next_scan_ < options_.frames) {
    const int k = next_scan_++;
    const double time = static_cast<double>(StampOf(k)) * 1e-9;
    const double share = ShareOfReturns(time);
    if (share <= 0.0) continue;
    *scan = RadarScan();
    *truth = GroundTruth();
    scan->stamp_ns = StampOf(k);
    scan->has_doppler = true;
    scan->is_planar = sensor().is_planar;
    scan->place = "simulated scan " + std::to_string(k);
    const VehicleMotion::BodyState body = motion_.BodyAt(time);
    truth->T_world_radar = body.T_world_body * T_body_radar_;
    truth->v_radar = T_body_radar_.rotation.conjugate() *
                     (body.v_body + body.omega_body.cross(T_body_radar_.translation));
    sampler_.Draw(traffic_.CarsAt(time, motion_.TravelAt(time)),
                  share,
                  SeedOf(options_.seed, 1000 + static_cast<std::uint64_t>(k)),
                  scan,
                  truth);
    return true;
  }
  return false;
}

}  // namespace radive
