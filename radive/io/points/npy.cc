// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/npy.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/number_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

struct NpyHeader {
  NumericType type = NumericType::kFloat32;
  bool is_big_endian = false;
  bool is_fortran_order = false;
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
};

// The text behind 'key': in the dictionary of the header; empty when there is no such key.
std::string_view ValueOf(std::string_view dictionary, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted = quote + std::string(key) + quote;
    const std::size_t place = dictionary.find(quoted);
    if (place == std::string_view::npos) continue;
    std::string_view rest = TrimBlanks(dictionary.substr(place + quoted.size()));
    if (rest.empty() || rest.front() != ':') continue;
    return TrimBlanks(rest.substr(1));
  }
  return {};
}

bool ReadType(std::string_view value, NpyHeader* header) {
  if (value.size() < 5) return false;
  const std::string_view type = value.substr(1, 3);
  header->is_big_endian = type[0] == '>';
  header->type = type[2] == '8' ? NumericType::kFloat64 : NumericType::kFloat32;
  return (type[0] == '<' || type[0] == '>') && type[1] == 'f' &&
         (type[2] == '4' || type[2] == '8') && value[4] == value[0];
}

// "(322, 5)"
bool ReadShape(std::string_view value, NpyHeader* header) {
  const std::size_t end = value.find(')');
  if (value.empty() || value.front() != '(' || end == std::string_view::npos) return false;
  value = value.substr(1, end - 1);
  const std::size_t comma = value.find(',');
  if (comma == std::string_view::npos) return false;
  const auto rows = ParseCount(TrimBlanks(value.substr(0, comma)));
  std::string_view second = TrimBlanks(value.substr(comma + 1));
  if (!second.empty() && second.back() == ',') second.remove_suffix(1);
  const auto columns = ParseCount(TrimBlanks(second));
  if (!rows || !columns || *columns == 0 || *columns > kMostColumns) return false;
  header->rows = *rows;
  header->columns = *columns;
  return true;
}

// What the user can do about an array that is not as expected.
std::string Advice(std::string_view descr, std::string_view shape) {
  if (descr.substr(0, 1) == "[") {
    return "; a structured array: save its columns side by side, as " +
           std::string("numpy.lib.recfunctions.structured_to_unstructured does");
  }
  const std::string_view type = descr.substr(std::min<std::size_t>(1, descr.size()));
  if (type.substr(0, 2) == "|O" || type.substr(0, 1) == "O") {
    return "; it holds pickled Python objects, which are not read";
  }
  NpyHeader ignored;
  return ReadShape(shape, &ignored) ? "; save it with astype(numpy.float32)" : "";
}

// Reads the header and takes it off `bytes`.
bool ReadHeader(std::string_view* bytes, NpyHeader* header, std::string* error) {
  const std::size_t size_bytes = bytes->size() > 6 && (*bytes)[6] == 1 ? 2 : 4;
  if (bytes->substr(0, kMagic.size()) != kMagic || bytes->size() < 8 + size_bytes) {
    *error = "expected a NumPy array, which starts with \\x93NUMPY";
    if (bytes->substr(0, 4) == "PK\x03\x04")
      *error += "; a zip archive (npz) holds arrays in files";
    return false;
  }
  const std::size_t size = size_bytes == 2 ? NumberAt<std::uint16_t>(bytes->data() + 8)
                                           : NumberAt<std::uint32_t>(bytes->data() + 8);
  bytes->remove_prefix(8 + size_bytes);
  if (size > bytes->size()) {
    *error = "the header of the NumPy array is cut off";
    return false;
  }
  const std::string_view dictionary = bytes->substr(0, size);
  bytes->remove_prefix(size);
  const std::string_view order = ValueOf(dictionary, "fortran_order");
  header->is_fortran_order = order.substr(0, 4) == "True";
  if (!ReadType(ValueOf(dictionary, "descr"), header) ||
      (!header->is_fortran_order && order.substr(0, 5) != "False") ||
      !ReadShape(ValueOf(dictionary, "shape"), header)) {
    *error = "expected an array of float32 or float64 with two dimensions, a point a row, found " +
             Quoted(dictionary) +
             Advice(ValueOf(dictionary, "descr"), ValueOf(dictionary, "shape"));
    return false;
  }
  return true;
}

bool NameColumns(const NpyHeader& header,
                 std::vector<std::string> columns,
                 PointTable* table,
                 std::string* error) {
  if (columns.empty() && header.columns >= 3 && header.columns <= 5) {
    columns = {"x", "y", "z", "power", "doppler"};
    columns.resize(static_cast<std::size_t>(header.columns));
  }
  if (columns.size() != header.columns) {
    *error = "the array has " + std::to_string(header.columns) +
             " columns; expected 3 (x y z), 4 (and power), 5 (and doppler), or as many names in " +
             "input.layout";
    if (header.rows <= 20 && header.rows < header.columns) *error += "; is it transposed?";
    return false;
  }
  for (std::string& name : columns) table->AddField(std::move(name), header.type);
  table->fields.erase(std::remove_if(table->fields.begin(),
                                     table->fields.end(),
                                     [](const PointField& field) { return field.name == "_"; }),
                      table->fields.end());
  return true;
}

}  // namespace

bool ParseNpy(std::string_view bytes,
              const std::vector<std::string>& columns,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error) {
  *table = PointTable();
  NpyHeader header;
  if (!ReadHeader(&bytes, &header, error) || !NameColumns(header, columns, table, error)) {
    return false;
  }
  table->is_big_endian = header.is_big_endian;
  const std::size_t fit = bytes.size() / table->stride;
  table->num_points = std::min<std::uint64_t>(header.rows, fit);
  if (table->num_points < header.rows) {
    const std::string found = "the header promises " + std::to_string(header.rows) +
                              " points, the data hold " + std::to_string(table->num_points);
    if (header.is_fortran_order) {
      *error = found;
      return false;
    }
    remarks->push_back(found);
  }
  if (const std::size_t used = table->num_points * table->stride;
      table->num_points == header.rows && bytes.size() > used) {
    remarks->push_back(std::to_string(bytes.size() - used) +
                       " bytes behind the last point are ignored");
  }
  table->data = bytes.data();
  if (!header.is_fortran_order) return true;
  // All values of the first column, then all of the second ...: back to rows.
  const std::size_t size = SizeOf(header.type);
  table->owned.resize(table->num_points * table->stride);
  const char* from = bytes.data();
  for (std::size_t column = 0; column < header.columns; ++column) {
    for (std::size_t i = 0; i < table->num_points; ++i) {
      std::copy_n(from, size, table->owned.data() + i * table->stride + column * size);
      from += size;
    }
  }
  table->data = table->owned.data();
  return true;
}

}  // namespace radive
