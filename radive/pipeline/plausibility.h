// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "radive/odometry/odometry_result.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Tells from a whole drive, or its first scans, whether lengths and times have the right unit:
// odometry would take millimetres for metres without a word. Looks at the first scans alone, so its
// size does not grow with the drive.
class Plausibility {
 public:
  void AddScan(const RadarScan& scan);
  void AddPose(const OdometryResult& result);  // of the same scan

  // What is not plausible and which unit would explain it; empty: all is well.
  std::vector<std::string> Warnings() const;

 private:
  struct Pose {
    std::int64_t stamp_ns;
    Rigid3 T_world_body;
  };

  std::vector<double> ranges_;     // of returns [m]
  std::vector<double> intervals_;  // between scans of one radar [s]
  std::vector<double> speeds_;     // between registered poses [m/s]
  std::map<int, std::int64_t> last_stamp_ns_;
  std::vector<Pose> last_pose_;  // one, or none
};

}  // namespace radive
