// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "radive/odometry/odometry_result.h"
#include "radive/util/counted_warnings.h"

namespace radive {

// Warns of stretches of a drive in which no scan was registered or found standing: their poses go
// on at the velocity before, and look like any other in the trajectory.
class PredictedPoses {
 public:
  // The next scan. `place`: where it was read.
  void Add(const OdometryResult& result, const std::string& place);
  // No scan follows.
  void Finish();

  // Cleared by the call.
  std::vector<std::string> TakeWarnings() { return counted_.Take(); }

 private:
  void EndStretch();

  int num_scans_ = 0;  // of the drive
  int num_predicted_ = 0;
  std::string first_;  // why the first of them is

  // The stretch that goes on.
  int length_ = 0;  // [scans]
  std::int64_t begin_ns_ = 0, end_ns_ = 0;
  std::string reason_, place_;  // of its first scan

  bool has_warned_ = false;
  CountedWarnings counted_;
};

}  // namespace radive
