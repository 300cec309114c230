// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Beam of a simulated radar in one angle: a main lobe and a floor over the whole field of view.
struct BeamPattern {
  double half_view = 0.0;    // field of view is +- this [rad]
  double center = 0.0;       // of the main lobe [rad]
  double lobe = 0.0;         // standard deviation of the main lobe [rad]
  double floor_share = 0.0;  // share of the returns that come from the floor [-]
};

// What a simulated radar measures and how well. Noise is Gaussian and unbiased.
struct SensorModel {
  double rate = 10.0;             // scans per second [Hz]
  double returns_per_scan = 100;  // mean
  double returns_spread = 0.05;   // its standard deviation, as a share of the mean [-]
  bool is_planar = false;         // measures no elevation: z = 0 in all returns
  BeamPattern azimuth;            // positive to the left
  BeamPattern elevation;          // positive up
  double min_range = 1.0;         // [m]
  double max_range = 200.0;       // [m]
  double half_range = 120.0;      // where the probability of detection has fallen to 1/2 [m]
  double sigma_range = 0.1;       // [m]
  double sigma_azimuth = 0.02;    // [rad]
  double sigma_elevation = 0.02;  // [rad]
  double sigma_doppler = 0.1;     // [m/s]
  double scatterer_share = 0.3;   // share of the static returns that repeatable scatterers give
};

enum class SensorType {
  kOculii,    // dense 4D radar: Oculii Eagle, enhanced cloud
  kArs548,    // sparse 4D radar: Continental ARS548
  kPlanar2d,  // corner radar without elevation, as those of RadarScenes
};

SensorModel MakeSensorModel(SensorType type);

}  // namespace radive
