// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Options of the whole odometry: those of each stage.
struct OdometryOptions {
  // Threads for the parallel parts; results do not depend on it.
  int num_threads = 1;

  // The settings stage by stage, as configuration files name them: "registration" -> its fields.
  std::vector<std::pair<std::string, std::vector<OptionField>>> Stages();

  bool IsValid(std::string* error) const;
};

}  // namespace radive
