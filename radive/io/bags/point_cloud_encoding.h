// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include "radive/sensor/radar_scan.h"

namespace radive {

// The scan as a serialised sensor_msgs PointCloud2 with the float32 fields x, y, z [m], doppler
// [m/s] and power [dB], 20 bytes a point, and the header stamp of the scan. `encoding` is "ros1" or
// "cdr"; ROS 1 has no stamps before 1970.
std::string EncodePointCloud2(const RadarScan& scan,
                              std::string_view encoding,
                              const std::string& frame_id);

// The fields of PointCloud2 in the language of message definitions, with those of the messages in
// it, for containers that store them; for "ros1" or "cdr".
std::string PointCloud2Definition(std::string_view encoding);

// The checksum by which ROS 1 knows the version of PointCloud2.
constexpr const char* kPointCloud2Md5 = "1158d486dd51d683ce2f1be655c3c181";

}  // namespace radive
