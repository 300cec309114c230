// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "radive/config/output_options.h"
#include "radive/config/perturbation_options.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/trajectories/reference_options.h"
#include "radive/odometry/odometry_options.h"
#include "radive/util/option_field.h"

namespace radive {

// Everything that a run of radive_odometry can be told by a configuration file.
struct RunConfig {
  InputOptions input;
  OdometryOptions odometry;
  OutputOptions output;
  ReferenceOptions reference;
  PerturbationOptions perturbation;

  // All settings as configuration files name them: ("registration", its fields). The fields point
  // into this object.
  std::vector<std::pair<std::string, std::vector<OptionField>>> Stages();

  // True when all settings are in range and fit each other; otherwise `error` names the first
  // that does not.
  bool IsValid(std::string* error) const;
};

}  // namespace radive
