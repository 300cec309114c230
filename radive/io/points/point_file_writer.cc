// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/point_file_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "radive/io/bytes/lzf.h"
#include "radive/io/points/point_table.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr std::size_t kNumFields = 5;

std::array<float, kNumFields> Values(const RadarReturn& ret) {
  return {static_cast<float>(ret.position.x()),
          static_cast<float>(ret.position.y()),
          static_cast<float>(ret.position.z()),
          static_cast<float>(ret.doppler),
          static_cast<float>(ret.power)};
}

std::string Text(float value) { return FormatText("%.9g", static_cast<double>(value)); }

void AppendTextLine(const RadarReturn& ret, char separator, std::string* text) {
  std::size_t i = 0;
  for (const float value : Values(ret)) {
    *text += Text(value);
    *text += ++i < kNumFields ? separator : '\n';
  }
}

void AppendFloats(std::initializer_list<float> values, std::string* bytes) {
  for (const float value : values) AppendLittleEndian(value, bytes);
}

std::string PcdHeaderText(const std::string& names, std::size_t count, const char* data) {
  std::string sizes, types, counts;
  for (std::size_t i = 0;
       i <= static_cast<std::size_t>(std::count(names.begin(), names.end(), ' '));
       ++i) {
    sizes += " 4";
    types += " F";
    counts += " 1";
  }
  const std::string number = std::to_string(count);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + names + "\nSIZE" +
         sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + number +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA " + data + "\n";
}

}  // namespace

std::string PcdBytes(const std::vector<RadarReturn>& returns, PcdEncoding encoding) {
  const char* const names = "x y z doppler power";
  if (encoding == PcdEncoding::kAscii) {
    std::string text = PcdHeaderText(names, returns.size(), "ascii");
    for (const RadarReturn& ret : returns) AppendTextLine(ret, ' ', &text);
    return text;
  }
  if (encoding == PcdEncoding::kBinary) {
    return PcdHeaderText(names, returns.size(), "binary") + RawBytes(returns);
  }
  std::string columns;
  for (std::size_t field = 0; field < kNumFields; ++field) {
    for (const RadarReturn& ret : returns) AppendLittleEndian(Values(ret)[field], &columns);
  }
  const std::string packed = PackLzf(columns);
  std::string bytes = PcdHeaderText(names, returns.size(), "binary_compressed");
  AppendLittleEndian(static_cast<std::uint32_t>(packed.size()), &bytes);
  AppendLittleEndian(static_cast<std::uint32_t>(columns.size()), &bytes);
  return bytes + packed;
}

std::string SnailPcdBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes =
      PcdHeaderText("x y z doppler intensity range_std azimuth_std elevation_std doppler_std",
                    returns.size(),
                    "binary");
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    AppendFloats({x, y, z, doppler, power + 128.0F, 0.0F, 0.0F, 0.0F, 0.0F}, &bytes);
  }
  return bytes;
}

std::string PlyBytes(const std::vector<RadarReturn>& returns, PlyEncoding encoding) {
  constexpr const char* kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string bytes = "ply\nformat " + std::string(kFormats[static_cast<int>(encoding)]) +
                      " 1.0\nelement vertex " + std::to_string(returns.size()) + "\n";
  for (const char* name : {"x", "y", "z", "doppler", "power"}) {
    bytes += "property float " + std::string(name) + "\n";
  }
  bytes += "end_header\n";
  for (const RadarReturn& ret : returns) {
    if (encoding == PlyEncoding::kAscii) {
      AppendTextLine(ret, ' ', &bytes);
      continue;
    }
    for (const float value : Values(ret)) {
      AppendLittleEndian(value, &bytes);
      if (encoding == PlyEncoding::kBigEndian) std::reverse(bytes.end() - 4, bytes.end());
    }
  }
  return bytes;
}

std::string CsvBytes(const std::vector<RadarReturn>& returns) {
  std::string text = "x,y,z,doppler,power\n";
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    text += FormatText("%.17g,%.17g,%.17g,%.17g,%.17g\n",
                       static_cast<double>(x),
                       static_cast<double>(y),
                       static_cast<double>(z),
                       static_cast<double>(doppler),
                       static_cast<double>(power));
  }
  return text;
}

std::string NpyBytes(const std::vector<RadarReturn>& returns) {
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                       std::to_string(returns.size()) + ", 5), }";
  // Up to the data the file is a multiple of 64 bytes long.
  constexpr std::size_t kFront = 10;  // magic, version and length [bytes]
  header.append(63 - (kFront + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\0", 8);
  AppendLittleEndian(static_cast<std::uint16_t>(header.size()), &bytes);
  bytes += header;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    AppendFloats({x, y, z, power, doppler}, &bytes);
  }
  return bytes;
}

std::string RawBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    for (const float value : Values(ret)) AppendLittleEndian(value, &bytes);
  }
  return bytes;
}

std::string VodBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    AppendFloats({x, y, z, power, doppler, 0.0F, 0.0F}, &bytes);
  }
  return bytes;
}

std::string HerculesBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    const Eigen::Vector3f position(x, y, z);
    const float range = position.norm();
    AppendFloats({x, y, z, doppler, range}, &bytes);
    const double whole = std::isfinite(power) ? std::clamp(std::round(power), -128.0F, 127.0F) : 0;
    AppendLittleEndian(static_cast<std::int8_t>(whole), &bytes);
    AppendFloats({std::atan2(y, x), range > 0.0F ? std::asin(z / range) : 0.0F}, &bytes);
  }
  return bytes;
}

std::string AevaBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    AppendFloats({x, y, z, 0.0F, doppler}, &bytes);  // reflectivity 0
    AppendLittleEndian(std::int32_t{0}, &bytes);     // time offset
    AppendLittleEndian(std::int8_t{0}, &bytes);      // line
    AppendFloats({power}, &bytes);
  }
  return bytes;
}

std::string Tj4dBytes(const std::vector<RadarReturn>& returns) {
  constexpr float kDegrees = 57.29577951F;
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    const float range = Eigen::Vector3f(x, y, z).norm();
    const float elevation = range > 0.0F ? std::asin(z / range) : 0.0F;
    AppendFloats(
        {x, y, z, doppler, range, power, -kDegrees * std::atan2(y, x), kDegrees * elevation},
        &bytes);
  }
  return bytes;
}

std::string ColoRadarBytes(const std::vector<RadarReturn>& returns) {
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const auto [x, y, z, doppler, power] = Values(ret);
    AppendFloats({x, y, z, power, doppler}, &bytes);
  }
  return bytes;
}

}  // namespace radive
