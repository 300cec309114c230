// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/point_file_writer.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/lzf.h"
#include "radive/io/points/field_matching.h"
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

std::string Text(float value) { return ShortText(static_cast<double>(value)); }

void AppendTextLine(const RadarReturn& ret, char separator, std::string* text) {
  std::size_t i = 0;
  for (const float value : Values(ret)) {
    *text += Text(value);
    *text += ++i < kNumFields ? separator : '\n';
  }
}

// In the order of FieldRole; the time of a return is 0.
std::array<float, kNumFieldRoles> ValuesOfRoles(const RadarReturn& ret, double power_offset) {
  const auto [x, y, z, doppler, power] = Values(ret);
  const float range = Eigen::Vector3f(x, y, z).norm();
  const float elevation = range > 0.0F ? std::asin(z / range) : 0.0F;
  return {x,
          y,
          z,
          range,
          std::atan2(y, x),
          elevation,
          doppler,
          power + static_cast<float>(power_offset),
          0.0F};
}

// Rounded and cut off at the limits of the type.
template <typename Integer>
void AppendInteger(float value, std::string* bytes) {
  const double whole = std::isfinite(value) ? std::round(static_cast<double>(value)) : 0.0;
  AppendLittleEndian(
      static_cast<Integer>(std::clamp(whole,
                                      static_cast<double>(std::numeric_limits<Integer>::min()),
                                      static_cast<double>(std::numeric_limits<Integer>::max()))),
      bytes);
}

void AppendAs(NumericType type, float value, std::string* bytes) {
  switch (type) {
    case NumericType::kFloat32:
      return AppendLittleEndian(value, bytes);
    case NumericType::kFloat64:
      return AppendLittleEndian(static_cast<double>(value), bytes);
    case NumericType::kInt8:
      return AppendInteger<std::int8_t>(value, bytes);
    case NumericType::kUint8:
      return AppendInteger<std::uint8_t>(value, bytes);
    case NumericType::kInt16:
      return AppendInteger<std::int16_t>(value, bytes);
    case NumericType::kUint16:
      return AppendInteger<std::uint16_t>(value, bytes);
    case NumericType::kInt32:
      return AppendInteger<std::int32_t>(value, bytes);
    case NumericType::kUint32:
      return AppendInteger<std::uint32_t>(value, bytes);
    case NumericType::kInt64:
    case NumericType::kUint64:
      break;
  }
  LOG(FATAL) << "records with 64-bit integers are not written";
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
    return PcdRecordBytes(returns, KnownLayout("xyzdp5"));
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
  return bytes + RecordBytes(returns, KnownLayout("x,y,z,power,doppler"));
}

std::string RecordBytes(const std::vector<RadarReturn>& returns,
                        const RawLayout& layout,
                        double power_offset) {
  std::string error;
  const std::optional<FieldMatch> match = MatchFields(layout.fields, {}, &error);
  CHECK(match) << error;
  std::string bytes;
  for (const RadarReturn& ret : returns) {
    const std::array<float, kNumFieldRoles> values = ValuesOfRoles(ret, power_offset);
    const std::size_t begin = bytes.size();
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      const PointField& field = layout.fields[i];
      bytes.resize(begin + field.offset, '\0');
      float value = 0.0F;
      for (std::size_t role = 0; role < kNumFieldRoles; ++role) {
        if ((*match)[static_cast<FieldRole>(role)] == static_cast<int>(i)) value = values[role];
      }
      AppendAs(field.type, value, &bytes);
    }
    bytes.resize(begin + layout.record_size, '\0');
  }
  return bytes;
}

std::string PcdRecordBytes(const std::vector<RadarReturn>& returns,
                           const RawLayout& layout,
                           double power_offset) {
  std::string names;
  for (const PointField& field : layout.fields) names += (names.empty() ? "" : " ") + field.name;
  return PcdHeaderText(names, returns.size(), "binary") +
         RecordBytes(returns, layout, power_offset);
}

}  // namespace radive
