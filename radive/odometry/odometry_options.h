// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "radive/ego_velocity/ego_velocity_options.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/ndt/ndt_options.h"
#include "radive/neural_map/neural_map_options.h"
#include "radive/neural_map/surface_options.h"
#include "radive/odometry/motion_options.h"
#include "radive/odometry/sdf_submap_options.h"
#include "radive/odometry/submap_options.h"
#include "radive/preprocessing/occlusion_options.h"
#include "radive/preprocessing/preprocessing_options.h"
#include "radive/registration/registration_options.h"
#include "radive/sensor/sensor_options.h"
#include "radive/training/sdf_training_options.h"
#include "radive/util/option_field.h"

namespace radive {

// Options of the whole odometry: those of each stage.
struct OdometryOptions {
  SensorOptions sensor;
  PreprocessingOptions preprocessing;
  OcclusionOptions occlusion;
  EgoVelocityOptions ego_velocity;
  NdtOptions ndt;
  PairOptions pairs;
  RegistrationOptions registration;
  MotionOptions motion;
  SubmapOptions submap;

  // With submap.type sdf:
  SdfSubmapOptions sdf_submap;
  NeuralMapOptions neural_map;
  SdfTrainingOptions training;
  SurfaceOptions surface;

  // Threads for the parallel parts; results do not depend on it.
  int num_threads = 1;

  // The settings stage by stage, as configuration files name them: "registration" -> its fields.
  std::vector<std::pair<std::string, std::vector<OptionField>>> Stages();

  bool IsValid(std::string* error) const;
};

}  // namespace radive
