// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/geometry/matrix_pose.h"

namespace radive {

// Length of the path from the first pose to each pose [m]; as many entries as poses.
inline std::vector<double> PathLengths(const std::vector<MatrixPose>& poses) {
  std::vector<double> lengths;
  lengths.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    lengths.push_back(
        i == 0 ? 0.0 : lengths.back() + (poses[i].translation - poses[i - 1].translation).norm());
  }
  return lengths;
}

}  // namespace radive
