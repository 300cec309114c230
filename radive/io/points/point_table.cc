// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/point_table.h"

#include "radive/io/bytes/byte_order.h"

namespace radive {
const char* NameOf(NumericType type) {
  switch (type) {
    case NumericType::kInt8:
      return "int8";
    case NumericType::kUint8:
      return "uint8";
    case NumericType::kInt16:
      return "int16";
    case NumericType::kUint16:
      return "uint16";
    case NumericType::kInt32:
      return "int32";
    case NumericType::kUint32:
      return "uint32";
    case NumericType::kInt64:
      return "int64";
    case NumericType::kUint64:
      return "uint64";
    case NumericType::kFloat32:
      return "float32";
    case NumericType::kFloat64:
      return "float64";
  }
  return "?";
}

bool PointTable::CheckFields(std::string* error) const {
  for (const PointField& field : fields) {
    const std::size_t size = SizeOf(field.type);
    if (field.count == 0) {
      *error = "field '" + field.name + "' has no numbers (count 0)";
      return false;
    }
    if (field.count <= stride / size && field.offset <= stride - size * field.count) continue;
    *error = "field '" + field.name + "' at byte " + std::to_string(field.offset) +
             " reaches beyond the record of " + std::to_string(stride) + " bytes";
    return false;
  }
  return true;
}

double ReadNumber(const char* bytes, NumericType type, bool is_big_endian) {
  switch (type) {
    case NumericType::kInt8:
      return static_cast<double>(NumberAt<std::int8_t>(bytes, is_big_endian));
    case NumericType::kUint8:
      return static_cast<double>(NumberAt<std::uint8_t>(bytes, is_big_endian));
    case NumericType::kInt16:
      return static_cast<double>(NumberAt<std::int16_t>(bytes, is_big_endian));
    case NumericType::kUint16:
      return static_cast<double>(NumberAt<std::uint16_t>(bytes, is_big_endian));
    case NumericType::kInt32:
      return static_cast<double>(NumberAt<std::int32_t>(bytes, is_big_endian));
    case NumericType::kUint32:
      return static_cast<double>(NumberAt<std::uint32_t>(bytes, is_big_endian));
    case NumericType::kInt64:
      return static_cast<double>(NumberAt<std::int64_t>(bytes, is_big_endian));
    case NumericType::kUint64:
      return static_cast<double>(NumberAt<std::uint64_t>(bytes, is_big_endian));
    case NumericType::kFloat32:
      return static_cast<double>(NumberAt<float>(bytes, is_big_endian));
    case NumericType::kFloat64:
      return NumberAt<double>(bytes, is_big_endian);
  }
  return 0.0;
}

}  // namespace radive
