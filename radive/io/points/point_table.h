// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace radive
