// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <vector>

#include "radive/simulation/radar_world.h"

namespace radive {

// Beam of a simulated radar in one angle: a main lobe and a floor over the whole field of view.
struct BeamPattern {
  double half_view = 0.0;    // field of view is +- this [rad]
  double center = 0.0;       // of the main lobe [rad]
  double lobe = 0.0;         // standard deviation of the main lobe [rad]
  double floor_share = 0.0;  // share of the returns that come from the floor [-]
};

// How a surface answers a ray. A ray that meets it at range r, with the cosine c between ray and
// normal, gives a return with the probability
//
//   reflection (rough + (1 - rough) c^sharpness) / (1 + (r / (reach half_range))^4)
//
// with the sensor's half_range: what is left of 1 near by is lost to mirroring away and to speckle,
// and the echo falls with the fourth power of the range.
struct Material {
  double reflection = 1.0;   // near by and straight on [-], in [0, 1]
  double rough = 0.25;       // share that does not depend on the angle [-]
  double sharpness = 1.0;    // how narrow the mirror lobe is [-]
  double reach = 1.0;        // factor on the range [-]
  double penetration = 0.0;  // mean depth of second returns behind it [m]; 0: none
  bool is_mirror = false;    // multipath bounces off it
};

// What a simulated sensor measures and how well. Noise is Gaussian and unbiased.
//
// A strong target fills several cells of a radar's spectrum, so that returns come in clusters: the
// rich get richer, and few voxels hold most of a scan.
struct SensorModel {
  double rate = 10.0;               // scans per second [Hz]
  double returns_per_scan = 100;    // mean
  double returns_spread = 0.05;     // its standard deviation, as a share of the mean [-]
  bool is_planar = false;           // measures no elevation: z = 0 in all returns
  BeamPattern azimuth;              // positive to the left
  BeamPattern elevation;            // positive up
  double min_range = 1.0;           // [m]
  double max_range = 200.0;         // [m]
  double half_range = 120.0;        // where the probability of detection has fallen to 1/2 [m]
  double sigma_range = 0.1;         // [m]
  double sigma_azimuth = 0.02;      // [rad]
  double sigma_elevation = 0.02;    // [rad]
  double sigma_doppler = 0.1;       // [m/s]
  double scatterer_share = 0.3;     // share of the static returns that repeatable scatterers give
  double cluster_share = 0.0;       // share of the rays that go beside an earlier return
  double cluster_angle = 0.0;       // ... by this standard deviation in both angles [rad]
  double target_correlation = 0.0;  // of the errors in range and angles on one target [-]
  double artefacts = 1.0;           // factor on the shares of ghosts, clutter and duplicates [-]

  // Antennas with few rows confuse elevations that are this far apart [rad].
  double elevation_ambiguity = 0.0;
  double ambiguous_share = 0.0;  // of the real returns that land on the wrong one [-]

  std::array<Material, kNumSurfaces> materials;  // by Surface
  const Material& material(Surface surface) const {
    return materials[static_cast<std::size_t>(surface)];
  }
};

enum class SensorType {
  kOculii,    // dense 4D radar: Oculii Eagle, enhanced cloud
  kArs548,    // sparse 4D radar: Continental ARS548
  kPlanar2d,  // corner radar without elevation, as those of RadarScenes
  kAeva,      // FMCW lidar: Aeva Aeries II, thinned to a fifth
};

const SensorModel& ModelOf(SensorType type);

// The words for SensorType in settings, in its order.
const std::vector<std::string>& SensorNames();

}  // namespace radive
