// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/sensor_model.h"

#include <glog/logging.h>

namespace radive {
namespace {

using Materials = std::array<Material, kNumSurfaces>;

constexpr double Degrees(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }

// Columns: reflection, rough, sharpness, reach, penetration, is_mirror. At millimetre waves plaster
// and concrete are half a mirror, metal answers from afar, and roads hardly at all.
const Materials kRadarMaterials = {{
    {0.06, 1.0, 1.0, 0.6, 0.0, false},  // ground
    {1.0, 0.25, 1.0, 1.0, 1.5, true},   // facade
    {1.0, 0.6, 1.0, 1.1, 0.0, false},   // pole: round, so that some part of it always faces the ray
    {1.0, 0.3, 1.0, 1.2, 1.0, false},   // parked car: also under it to what is behind
    {1.0, 0.3, 1.0, 1.2, 0.8, false},   // moving car
    {0.5, 1.0, 1.0, 0.7, 1.5, false},   // vegetation
    {0.8, 0.12, 2.0, 0.9, 0.0, true},   // concrete
}};

// In the near infrared nearly everything is rough, and black cars are hardly seen.
const Materials kLidarMaterials = {{
    {0.7, 0.1, 1.0, 0.8, 0.0, false},  // ground
    {1.0, 0.3, 1.0, 1.0, 0.0, false},  // facade
    {1.0, 0.5, 1.0, 1.0, 0.0, false},  // pole
    {0.7, 0.2, 1.0, 0.7, 0.0, false},  // parked car
    {0.7, 0.2, 1.0, 0.7, 0.0, false},  // moving car
    {0.9, 1.0, 1.0, 0.8, 1.5, false},  // vegetation
    {0.9, 0.2, 1.0, 0.9, 0.0, false},  // concrete
}};

// Field of view and noise are those of the data sheets; lobes, half ranges, counts and Doppler
// noise are chosen so that scans spread as real ones do (docs/simulation.md).
SensorModel Oculii() {
  SensorModel model;
  model.rate = 12.0;
  model.returns_per_scan = 5000;
  model.returns_spread = 0.12;
  model.azimuth = {Degrees(56.5), 0.0, Degrees(14.0), 0.25};
  model.elevation = {Degrees(22.5), Degrees(1.5), Degrees(3.2), 0.15};
  model.max_range = 200.0;
  model.half_range = 165.0;
  model.sigma_range = 0.10;
  model.sigma_azimuth = Degrees(0.6);
  model.sigma_elevation = Degrees(1.5);
  model.sigma_doppler = 0.07;
  model.scatterer_share = 0.3;
  model.cluster_share = 0.75;
  model.cluster_angle = Degrees(0.4);
  model.target_correlation = 0.9;
  model.materials = kRadarMaterials;
  return model;
}

SensorModel Ars548() {
  SensorModel model;
  model.rate = 20.0;
  model.returns_per_scan = 150;
  model.returns_spread = 0.1;
  model.azimuth = {Degrees(60.0), 0.0, Degrees(22.0), 0.4};
  model.elevation = {Degrees(10.0), Degrees(0.5), Degrees(3.0), 0.2};
  model.max_range = 200.0;
  model.half_range = 100.0;
  model.sigma_range = 0.12;
  model.sigma_azimuth = Degrees(0.3);
  model.sigma_elevation = Degrees(0.8);
  model.sigma_doppler = 0.08;
  model.scatterer_share = 0.7;
  model.elevation_ambiguity = Degrees(11.0);
  model.ambiguous_share = 0.02;
  model.materials = kRadarMaterials;
  return model;
}

SensorModel Planar2d() {
  SensorModel model;
  model.rate = 13.0;
  model.returns_per_scan = 225;
  model.returns_spread = 0.1;
  model.is_planar = true;
  model.azimuth = {Degrees(60.0), 0.0, Degrees(25.0), 0.5};
  model.elevation = {Degrees(6.0), Degrees(0.5), Degrees(2.0), 0.2};
  model.max_range = 100.0;
  model.half_range = 70.0;
  model.sigma_range = 0.10;
  model.sigma_azimuth = Degrees(0.5);
  model.sigma_elevation = 0.0;
  model.sigma_doppler = 0.10;
  model.scatterer_share = 0.6;
  model.materials = kRadarMaterials;
  return model;
}

// Every direction alike; fifty times the accuracy of the radars in angle.
SensorModel Aeva() {
  SensorModel model;
  model.rate = 10.0;
  model.returns_per_scan = 12000;
  model.returns_spread = 0.02;
  model.azimuth = {Degrees(60.0), 0.0, Degrees(30.0), 1.0};
  model.elevation = {Degrees(9.6), 0.0, Degrees(5.0), 1.0};
  model.min_range = 2.0;
  model.max_range = 250.0;
  model.half_range = 150.0;
  model.sigma_range = 0.03;
  model.sigma_azimuth = Degrees(0.03);
  model.sigma_elevation = Degrees(0.03);
  model.sigma_doppler = 0.03;
  model.scatterer_share = 0.0;
  model.artefacts = 0.1;
  model.materials = kLidarMaterials;
  return model;
}

}  // namespace

const SensorModel& ModelOf(SensorType type) {
  static const std::vector<SensorModel> models = {Oculii(), Ars548(), Planar2d(), Aeva()};
  const auto i = static_cast<std::size_t>(type);
  CHECK_LT(i, models.size());
  return models[i];
}

const std::vector<std::string>& SensorNames() {
  static const std::vector<std::string> names = {"oculii", "ars548", "planar2d", "aeva"};
  return names;
}

}  // namespace radive
