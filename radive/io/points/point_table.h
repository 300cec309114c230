// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace radive {

// How a number is stored in a point record.
enum class NumericType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

// [bytes]
constexpr std::size_t SizeOf(NumericType type) {
  switch (type) {
    case NumericType::kInt8:
    case NumericType::kUint8:
      return 1;
    case NumericType::kInt16:
    case NumericType::kUint16:
      return 2;
    case NumericType::kInt32:
    case NumericType::kUint32:
    case NumericType::kFloat32:
      return 4;
    case NumericType::kInt64:
    case NumericType::kUint64:
    case NumericType::kFloat64:
      return 8;
  }
  return 8;
}

// "float32", "uint8", ...
const char* NameOf(NumericType type);

// A table with more columns than this is none of points.
inline constexpr std::size_t kMostColumns = 1000;

// One number, or `count` numbers side by side, of a point record.
struct PointField {
  std::string name;  // as the data have it
  NumericType type = NumericType::kFloat32;
  std::size_t offset = 0;  // from the start of the record [bytes]
  std::size_t count = 1;
};

// The points of one scan as they are stored: records of `stride` bytes, one after the other, with
// the same fields in each. What every format is brought to before PointConverter makes a scan of
// it. A view: `data` belongs to the caller, or to `owned`, where the stored form had to be
// unpacked. Moving keeps `data` valid.
struct PointTable {
  std::vector<PointField> fields;
  std::size_t stride = 0;      // [bytes]
  std::size_t num_points = 0;  // records
  bool is_big_endian = false;
  const char* data = nullptr;  // num_points * stride bytes, need not be aligned
  std::vector<char> owned;

  PointTable() = default;
  PointTable(PointTable&&) = default;
  PointTable& operator=(PointTable&&) = default;

  // Appends a field behind those that are there and makes the records longer by it.
  void AddField(std::string name, NumericType type, std::size_t count = 1) {
    fields.push_back({std::move(name), type, stride, count});
    stride += SizeOf(type) * count;
  }

  // False, with the field in `error`, when a field is empty or reaches beyond the record, and so
  // would be read beyond the data.
  bool CheckFields(std::string* error) const;
};

// The number of the given type at `bytes`, which need not be aligned, as a double. Integers beyond
// 2^53 are rounded.
double ReadNumber(const char* bytes, NumericType type, bool is_big_endian);

// The value of `Unsigned` at `bytes`, whatever this machine's order.
template <typename Unsigned>
Unsigned ReadUnsigned(const char* bytes, bool is_big_endian) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    const std::size_t place = is_big_endian ? i : sizeof(Unsigned) - 1 - i;
    value = static_cast<Unsigned>((static_cast<std::uint64_t>(value) << 8) |
                                  static_cast<unsigned char>(bytes[place]));
  }
  return value;
}

// Appends the bytes of `value`, little-endian. The other way round of ReadNumber(), for writers.
template <typename Number>
void AppendLittleEndian(Number value, std::string* bytes) {
  unsigned char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  const std::uint16_t probe = 1;
  unsigned char first = 0;
  std::memcpy(&first, &probe, 1);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    *bytes += static_cast<char>(raw[first == 1 ? i : sizeof(Number) - 1 - i]);
  }
}

// The bytes of `value`, little-endian.
template <typename Number>
std::string LittleEndian(Number value) {
  std::string bytes;
  AppendLittleEndian(value, &bytes);
  return bytes;
}

}  // namespace radive
