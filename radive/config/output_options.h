// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// What the results folder gets besides the trajectory and the tables.
struct OutputOptions {
  enum class Map { kNone, kPoints };
  enum class Frame {
    kBody,      // of the odometry, motion.body
    kRadar,     // the radar of the first scan
    kVehicle,   // origin at the rear axle, see SensorOptions
    kReference  // the body whose poses the ground truth has, see ReferenceOptions
  };

  // Whose pose the trajectory files, scans.csv and map.ply are of. The world frame is that body's
  // at the first scan. The odometry itself does not depend on it.
  Frame frame = Frame::kBody;

  // map.ply: nothing, or the points of all keyframes in the world frame.
  Map map = Map::kPoints;

  // Edge of the cubes in which the map keeps one point [m]; 0 keeps all.
  double map_resolution = 0.25;

  std::vector<OptionField> Fields() {
    return {
        {"frame",
         MakeChoice(&frame, {"body", "radar", "vehicle", "reference"}),
         "-",
         "Whose pose is written: that of motion.body, of the radar (of the first scan), of the "
         "vehicle (sensor.mount_*), or of the ground truth's body (reference.mount)."},
        {"map",
         MakeChoice(&map, {"none", "points"}),
         "-",
         "What map.ply holds: nothing (no file), or the points of all keyframes."},
        OptionField{"map_resolution",
                    &map_resolution,
                    "m",
                    "Edge of the cubes in which map.ply keeps one point each; 0 keeps all points."}
            .AtLeast(0.0),
    };
  }

  bool IsValid(std::string* error) const { return CheckOptions("output", *this, error); }
};

}  // namespace radive
