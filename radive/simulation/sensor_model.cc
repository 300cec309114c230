// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/sensor_model.h"

#include <glog/logging.h>

namespace radive {
namespace {

constexpr double Degrees(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }

// Field of view and noise are those of the data sheets; lobes and half ranges are chosen so that
// ranges and angles spread as in real recordings (scripts/compare_simulation.py).
SensorModel Oculii() {
  SensorModel model;
  model.rate = 12.0;
  model.returns_per_scan = 7500;
  model.azimuth = {Degrees(56.5), 0.0, Degrees(14.0), 0.35};
  model.elevation = {Degrees(22.5), Degrees(1.0), Degrees(3.0), 0.15};
  model.max_range = 200.0;
  model.half_range = 120.0;
  model.sigma_range = 0.10;
  model.sigma_azimuth = Degrees(1.0);
  model.sigma_elevation = Degrees(1.5);
  model.sigma_doppler = 0.10;
  model.scatterer_share = 0.3;
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
  return model;
}

}  // namespace

SensorModel MakeSensorModel(SensorType type) {
  switch (type) {
    case SensorType::kOculii:
      return Oculii();
    case SensorType::kArs548:
      return Ars548();
    case SensorType::kPlanar2d:
      return Planar2d();
  }
  LOG(FATAL) << "unknown sensor type " << static_cast<int>(type);
  return {};
}

}  // namespace radive
