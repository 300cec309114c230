// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/io/points/raw_layout.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

enum class PcdEncoding { kAscii, kBinary, kCompressed };
enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

// Files with the points of one scan, as their readers take them: fields x y z doppler power, all
// float32; numbers in text have nine digits, which give the same float32 back, but for CSV, which
// has no types: its 17 digits give the same double.
std::string PcdBytes(const std::vector<RadarReturn>& returns, PcdEncoding encoding);
std::string PlyBytes(const std::vector<RadarReturn>& returns, PlyEncoding encoding);
std::string CsvBytes(const std::vector<RadarReturn>& returns);

// Array of rows x y z power doppler, as K-Radar has it.
std::string NpyBytes(const std::vector<RadarReturn>& returns);

// Raw records, or the binary PCD of such records: what a return has no value for is 0, integers are
// rounded. `power_offset` is added to the power [dB].
std::string RecordBytes(const std::vector<RadarReturn>& returns,
                        const RawLayout& layout,
                        double power_offset = 0.0);
std::string PcdRecordBytes(const std::vector<RadarReturn>& returns,
                           const RawLayout& layout,
                           double power_offset = 0.0);

}  // namespace radive
