// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// The records of a raw file, which say nothing of themselves.
struct RawLayout {
  std::string name;  // as the user gave it
  std::vector<PointField> fields;
  std::size_t record_size = 0;  // [bytes]
};

// Names and columns of the layouts that are known:
//   xyz3           x y z
//   xyzdp5         x y z doppler power
//   vod7           View-of-Delft: x y z RCS v_r v_r_compensated time
//   tj4d8          TJ4DRadSet: x y z v_r range power alpha beta
//   mscrad17       MSC-RAD4R: x y z (4 unused) alpha beta range doppler power recoveredSpeed
//                  dotFlags denoiseFlag (2 unused)
//   coloradar5     ColoRadar: x y z intensity doppler
//   dualradar5     Dual-Radar: x y z rcs v_r
//   dicp4          Doppler-ICP: x y z doppler
//   kitti4         x y z intensity
//   hercules29     HeRCULES Continental: x y z v r, RCS as int8, azimuth elevation
//   aeva29 aeva25  HeRCULES Aeva: x y z reflectivity velocity, time_offset_ns as int32, line_index
//                  as uint8, and in the longer one intensity
//   aeva           the same of either length, each file by its size; where columns are asked for,
//                  the longer
//   boreas_aeva40  Boreas-RT Aeva: x y z v intensity signal_quality reflectivity time, flags
//   boreas_aeva7   Boreas Aeva, older: x y z intensity doppler laser_number time
const std::vector<std::string>& RawLayoutNames();

// Reads a layout: one of the names, or the columns in their order, separated by commas, in brackets
// or without: x, y, z or range, azimuth, elevation; doppler (or v_r, velocity, range_rate ...);
// power (or snr, rcs, intensity ...); and _ for a column to ignore. A column is little-endian
// float32 unless its type follows: rcs:int8 (uint8, int16 ... float64). Case does not matter.
// Nothing, and what is wrong in `error`, for anything else; in particular an unknown column is an
// error, so that a misspelt doppler is not lost in silence.
std::optional<RawLayout> ParseRawLayout(const std::string& text, std::string* error);

// The same for a text that was checked, or is our own: its columns may have any names.
RawLayout KnownLayout(const std::string& text);

// Names of the known layouts whose records divide a file of that size [bytes].
std::vector<std::string> LayoutsOfSize(std::size_t size);

}  // namespace radive
