// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace radive {

// Which column of a raw float32 record means what; -1: the record has no such column.
struct RawLayout {
  std::string name;  // as the user gave it
  int num_columns = 0;
  int x = -1;        // [m], FLU
  int y = -1;        // [m]
  int z = -1;        // [m]; none: the sensor measures no elevation
  int doppler = -1;  // range rate [m/s]
  int power = -1;    // [dB or dBsm]

  std::size_t record_size() const { return 4 * static_cast<std::size_t>(num_columns); }  // [bytes]
};

// Reads a layout: one of the names
//   xyz3    x y z
//   vod7    View-of-Delft: x y z RCS v_r, then the compensated v_r and the scan index, both ignored
//   xyzdp5  x y z doppler power
//   tj4d8   TJ4DRadSet: x y z v_r, range (ignored), power, two angles (ignored)
// or the columns in their order, separated by commas, in brackets or without: x, y, z, doppler (or
// v_r, velocity, range_rate ...), power (or snr, rcs, intensity ...), and _ for a column to ignore.
// Case does not matter. Nothing, and what is wrong in `error`, for anything else; in particular an
// unknown column is an error, so that a misspelt doppler is not lost in silence.
std::optional<RawLayout> ParseRawLayout(const std::string& text, std::string* error);

}  // namespace radive
