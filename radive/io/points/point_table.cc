// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/point_table.h"

namespace radive {
namespace {

template <typename Number, typename Unsigned>
double Read(const char* bytes, bool is_big_endian) {
  static_assert(sizeof(Number) == sizeof(Unsigned));
  const Unsigned bits = ReadUnsigned<Unsigned>(bytes, is_big_endian);
  Number value;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<double>(value);
}

}  // namespace

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
      return Read<std::int8_t, std::uint8_t>(bytes, is_big_endian);
    case NumericType::kUint8:
      return Read<std::uint8_t, std::uint8_t>(bytes, is_big_endian);
    case NumericType::kInt16:
      return Read<std::int16_t, std::uint16_t>(bytes, is_big_endian);
    case NumericType::kUint16:
      return Read<std::uint16_t, std::uint16_t>(bytes, is_big_endian);
    case NumericType::kInt32:
      return Read<std::int32_t, std::uint32_t>(bytes, is_big_endian);
    case NumericType::kUint32:
      return Read<std::uint32_t, std::uint32_t>(bytes, is_big_endian);
    case NumericType::kInt64:
      return Read<std::int64_t, std::uint64_t>(bytes, is_big_endian);
    case NumericType::kUint64:
      return Read<std::uint64_t, std::uint64_t>(bytes, is_big_endian);
    case NumericType::kFloat32:
      return Read<float, std::uint32_t>(bytes, is_big_endian);
    case NumericType::kFloat64:
      return Read<double, std::uint64_t>(bytes, is_big_endian);
  }
  return 0.0;
}

}  // namespace radive
