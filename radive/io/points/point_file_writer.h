// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

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

// Binary PCD with the nine fields that SNAIL-Radar has for the ARS548; the intensity is the power
// plus 128, the standard deviations are 0.
std::string SnailPcdBytes(const std::vector<RadarReturn>& returns);

// Array of rows x y z power doppler, as K-Radar has it.
std::string NpyBytes(const std::vector<RadarReturn>& returns);

// Records of raw layouts: xyzdp5; vod7, the compensated velocity 0; hercules29, the power rounded
// to int8; aeva29, the power as intensity; tj4d8; coloradar5.
std::string RawBytes(const std::vector<RadarReturn>& returns);
std::string VodBytes(const std::vector<RadarReturn>& returns);
std::string HerculesBytes(const std::vector<RadarReturn>& returns);
std::string AevaBytes(const std::vector<RadarReturn>& returns);
std::string Tj4dBytes(const std::vector<RadarReturn>& returns);
std::string ColoRadarBytes(const std::vector<RadarReturn>& returns);

}  // namespace radive
