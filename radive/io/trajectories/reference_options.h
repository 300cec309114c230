// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/util/option_field.h"

namespace radive {

// The ground truth of a drive: how its files are read, whose poses they are, and how they are
// matched with those of the odometry.
struct ReferenceOptions {
  enum class Format {
    kAuto,         // found out, see read_reference.h
    kTum,          // t x y z qx qy qz qw: NTU4DRadLM, HeRCULES, SNAIL-Radar
    kKitti,        // 12 numbers of [R | t], a line a scan: K-Radar
    kEuroc,        // t_ns x y z qw qx qy qz ...
    kTable,        // more columns, with names or without: SNAIL-Radar's ref_tls_T_xt32.csv
    kVod,          // View-of-Delft: pose/NNNNN.json and calib/NNNNN.txt, a pair a scan
    kRadarScenes,  // radarK_scans.csv
    kColoRadar,    // groundtruth_poses.txt and timestamps.txt
    kBoreas,       // applanix/aeva_poses.csv
    kDicp,         // Doppler-ICP: ref_poses.txt of the vehicle and calibration.json: of the sensor
    kRaFlow,       // radar_seqs-S_samples-K.json
    kBag           // poses or satellite fixes in a bag
  };
  enum class MountedOn { kRadar, kVehicle };

  Format format = Format::kAuto;

  // Topic of a bag; empty: the only one with poses.
  std::string topic;

  // Where the body sits whose poses these are: T_radar_reference or T_vehicle_reference as x, y, z
  // [m], roll, pitch, yaw [rad], the rotation Rz(yaw) Ry(pitch) Rx(roll). Empty: the poses are of
  // the radar, or of the vehicle, itself.
  MountedOn mounted_on = MountedOn::kRadar;
  std::vector<double> mount;

  // Poses belong together when their stamps differ by no more than this [s]; with interpolation
  // the reference is brought to the stamps of the estimate between two poses not further apart
  // than max_gap [s].
  double max_time_difference = 0.01;
  bool interpolate = false;
  double max_gap = 1.0;

  // T_radar_reference or T_vehicle_reference, see mounted_on.
  Rigid3 T_mount_reference() const;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;
};

// The words of `reference.format`, in the order of the enumerators.
const std::vector<std::string>& ReferenceFormatNames();

}  // namespace radive
