// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/pcd.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/lzf.h"
#include "radive/io/bytes/number_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr std::size_t kMostFields = 1000;
constexpr std::uint64_t kMostCount = 1u << 20;

enum class Encoding { kAscii, kBinary, kCompressed };

struct PcdHeader {
  std::vector<std::string_view> names, sizes, types, counts;
  std::optional<std::uint64_t> width, height, points;
  Encoding encoding = Encoding::kAscii;
  std::string_view payload;
};

bool TakeWords(std::string_view text, std::vector<std::string_view>* words) {
  words->clear();
  for (std::string_view word = TakeWord(&text); !word.empty(); word = TakeWord(&text)) {
    if (words->size() == kMostFields) return false;
    words->push_back(word);
  }
  return true;
}

bool ReadEncoding(std::string_view text, Encoding* encoding) {
  const std::string word = LowerCase(text);
  if (word == "ascii") return *encoding = Encoding::kAscii, true;
  if (word == "binary") return *encoding = Encoding::kBinary, true;
  if (word == "binary_compressed") return *encoding = Encoding::kCompressed, true;
  return false;
}

// Reads one line; sets `is_last` at the DATA line. Case does not matter, and keys that PCL does not
// know are left to whoever wrote them.
bool ReadHeaderLine(std::string_view line, PcdHeader* header, bool* is_last) {
  std::string_view rest = line;
  const std::string key = LowerCase(TakeWord(&rest));
  const auto read_count = [&](std::optional<std::uint64_t>* count) {
    *count = ParseCount(TakeWord(&rest));
    return count->has_value();
  };
  if (key == "fields" || key == "columns") return TakeWords(rest, &header->names);
  if (key == "size") return TakeWords(rest, &header->sizes);
  if (key == "type") return TakeWords(rest, &header->types);
  if (key == "count") return TakeWords(rest, &header->counts);
  if (key == "width") return read_count(&header->width);
  if (key == "height") return read_count(&header->height);
  if (key == "points") return read_count(&header->points);
  *is_last = key == "data";
  return !*is_last || ReadEncoding(TakeWord(&rest), &header->encoding);
}

bool ReadHeader(std::string_view bytes, PcdHeader* header, std::string* error) {
  bytes = WithoutByteOrderMark(bytes);
  std::size_t number = 0;
  while (true) {
    const std::size_t end = bytes.find('\n');
    std::string_view line = bytes.substr(0, end);
    ++number;
    if (end == std::string_view::npos) {
      *error = "line " + std::to_string(number) +
               ": the header of a PCD file ends without a DATA line, found " + Quoted(line);
      return false;
    }
    bytes.remove_prefix(end + 1);
    bool is_last = false;
    if (!ReadHeaderLine(line, header, &is_last)) {
      *error = "line " + std::to_string(number) +
               ": expected a line of a PCD header (FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, " +
               "POINTS, DATA ascii | binary | binary_compressed), found " + Quoted(line);
      return false;
    }
    if (is_last) break;
  }
  header->payload = bytes;
  return true;
}

std::optional<NumericType> TypeOf(std::string_view type, std::string_view size) {
  if (size.size() != 1 || type.size() != 1) return std::nullopt;
  const char upper = type[0] >= 'a' ? static_cast<char>(type[0] - 'a' + 'A') : type[0];
  switch (upper * 256 + size[0]) {
    case 'F' * 256 + '4':
      return NumericType::kFloat32;
    case 'F' * 256 + '8':
      return NumericType::kFloat64;
    case 'U' * 256 + '1':
      return NumericType::kUint8;
    case 'U' * 256 + '2':
      return NumericType::kUint16;
    case 'U' * 256 + '4':
      return NumericType::kUint32;
    case 'U' * 256 + '8':
      return NumericType::kUint64;
    case 'I' * 256 + '1':
      return NumericType::kInt8;
    case 'I' * 256 + '2':
      return NumericType::kInt16;
    case 'I' * 256 + '4':
      return NumericType::kInt32;
    case 'I' * 256 + '8':
      return NumericType::kInt64;
    default:
      return std::nullopt;
  }
}

// All fields, padding included, in the order of the file.
bool ReadFields(const PcdHeader& header, PointTable* table, std::string* error) {
  const std::size_t n = header.names.size();
  if (n == 0 || header.sizes.size() != n || header.types.size() != n ||
      (!header.counts.empty() && header.counts.size() != n)) {
    *error = "header: expected as many entries in SIZE, TYPE and COUNT as in FIELDS, found " +
             std::to_string(header.sizes.size()) + ", " + std::to_string(header.types.size()) +
             " and " + std::to_string(header.counts.size()) + " for " + std::to_string(n);
    return false;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto type = TypeOf(header.types[i], header.sizes[i]);
    const auto count =
        header.counts.empty() ? std::optional<std::uint64_t>(1) : ParseCount(header.counts[i]);
    if (!type || !count || *count == 0 || *count > kMostCount) {
      *error = "header: field " + Quoted(header.names[i]) +
               ": expected TYPE F, U or I with SIZE 1, 2, 4 or 8 (F: 4 or 8) and COUNT from 1, " +
               "found " + Quoted(header.types[i]) + ", " + Quoted(header.sizes[i]) +
               (header.counts.empty() ? "" : " and " + Quoted(header.counts[i]));
      return false;
    }
    table->AddField(std::string(header.names[i]), *type, static_cast<std::size_t>(*count));
  }
  return true;
}

void RemovePadding(PointTable* table) {
  auto& fields = table->fields;
  fields.erase(
      std::remove_if(
          fields.begin(), fields.end(), [](const PointField& field) { return field.name == "_"; }),
      fields.end());
}

std::optional<std::uint64_t> WidthTimesHeight(const PcdHeader& header) {
  if (!header.width || !header.height) return std::nullopt;
  if (*header.height != 0 && *header.width > UINT64_MAX / *header.height) return UINT64_MAX;
  return *header.width * *header.height;
}

// Number of points that the header promises: POINTS, or WIDTH times HEIGHT where that is missing or
// is what the data hold, which are `found` points.
std::optional<std::uint64_t> Promised(const PcdHeader& header, std::uint64_t found) {
  const std::optional<std::uint64_t> grid = WidthTimesHeight(header);
  return !header.points || grid == found ? grid : header.points;
}

void RemarkOnCount(const PcdHeader& header, std::size_t found, std::vector<std::string>* remarks) {
  const auto promised = Promised(header, found);
  if (!promised || *promised == found) return;
  remarks->push_back("the header promises " + std::to_string(*promised) +
                     " points, the data hold " + std::to_string(found));
}

bool ReadBinary(const PcdHeader& header, PointTable* table, std::vector<std::string>* remarks) {
  const std::size_t size = header.payload.size();
  const std::size_t num_fields = table->fields.size();
  const auto fits = [&](std::size_t stride) {
    return size % stride == 0 && Promised(header, size / stride) == size / stride;
  };
  if (!fits(table->stride) && fits(4 * num_fields)) {
    remarks->push_back("the declared sizes do not fit the data; every field is read as float32");
    PointTable floats;
    for (PointField& field : table->fields) {
      floats.AddField(std::move(field.name), NumericType::kFloat32);
    }
    *table = std::move(floats);
  }
  table->data = header.payload.data();
  table->num_points = size / table->stride;
  const auto promised = Promised(header, table->num_points);
  // Behind the points some writers leave more than one would want.
  if (promised && *promised < table->num_points) {
    table->num_points = static_cast<std::size_t>(*promised);
    remarks->push_back(std::to_string(size - table->num_points * table->stride) +
                       " bytes behind the last point are ignored");
  }
  RemarkOnCount(header, table->num_points, remarks);
  return true;
}

// Values side by side to where they belong in each record. `kWidth`: their width, where it is known
// to the compiler, which then needs no call for each of them; or 0.
template <std::size_t kWidth>
void ScatterColumn(
    const char* from, std::size_t width, std::size_t count, std::size_t stride, char* to) {
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(to + i * stride, from + i * width, kWidth > 0 ? kWidth : width);
  }
}

bool ReadCompressed(const PcdHeader& header, PointTable* table, std::string* error) {
  std::string_view payload = header.payload;
  if (payload.size() < 8) {
    *error = "expected the two sizes of the compressed data, found the end of the file";
    return false;
  }
  const std::size_t packed_size = NumberAt<std::uint32_t>(payload.data());
  const std::size_t size = NumberAt<std::uint32_t>(payload.data() + 4);
  payload.remove_prefix(8);
  const auto promised = Promised(header, size / table->stride);
  if (packed_size > payload.size() || size % table->stride != 0 ||
      (promised && size / table->stride != *promised)) {
    *error = "expected compressed data of " + std::to_string(promised.value_or(0)) + " points of " +
             std::to_string(table->stride) + " bytes, found " + std::to_string(payload.size()) +
             " of " + std::to_string(packed_size) + " compressed bytes that make " +
             std::to_string(size);
    return false;
  }
  std::vector<char> columns;
  if (!UnpackLzf(payload.substr(0, packed_size), size, &columns, error)) return false;
  // All values of the first field, then all of the second ...: back to records.
  table->num_points = size / table->stride;
  table->owned.resize(size);
  table->data = table->owned.data();
  if (table->num_points == 0) return true;
  const char* from = columns.data();
  for (const PointField& field : table->fields) {
    const std::size_t width = SizeOf(field.type) * field.count;
    char* const to = table->owned.data() + field.offset;
    if (width == sizeof(float)) {
      ScatterColumn<sizeof(float)>(from, width, table->num_points, table->stride, to);
    } else {
      ScatterColumn<0>(from, width, table->num_points, table->stride, to);
    }
    from += width * table->num_points;
  }
  return true;
}

bool IsBlank(std::string_view text) { return TakeWord(&text).empty(); }

// One line to the bytes of a record. False unless it holds a number for each field and no more.
bool ReadTextRecord(const PointTable& table, std::string_view line, std::string* record) {
  record->clear();
  for (const PointField& field : table.fields) {
    for (std::size_t k = 0; k < field.count; ++k) {
      const std::optional<double> value = ParseDouble(TakeWord(&line));
      if (!value) return false;
      if (field.type == NumericType::kFloat32) {
        AppendLittleEndian(static_cast<float>(*value), record);
      } else {
        AppendLittleEndian(*value, record);
      }
    }
  }
  return IsBlank(line);
}

// Values of float32 fields stay float32, all others become float64.
bool ReadAscii(const PcdHeader& header,
               PointTable* table,
               std::vector<std::string>* remarks,
               std::string* error) {
  PointTable text;
  for (PointField& field : table->fields) {
    const bool is_float = field.type == NumericType::kFloat32;
    text.AddField(std::move(field.name),
                  is_float ? NumericType::kFloat32 : NumericType::kFloat64,
                  field.count);
  }
  *table = std::move(text);
  std::string record;
  TextLines lines(header.payload);
  std::size_t num_bad = 0;
  std::string first_bad;
  for (std::string_view line; lines.Next(&line);) {
    if (IsBlank(line)) continue;
    if (!ReadTextRecord(*table, line, &record)) {
      if (num_bad++ > 0) continue;
      first_bad = "line " + std::to_string(lines.number()) +
                  " of the data: expected a number for each field, found " + Quoted(line);
      continue;
    }
    table->owned.insert(table->owned.end(), record.begin(), record.end());
    ++table->num_points;
  }
  if (num_bad > 0 && table->num_points == 0) {
    *error = first_bad;
    return false;
  }
  if (num_bad > 0) {
    remarks->push_back(first_bad + "; " + std::to_string(num_bad) + " such lines are left out");
  }
  const auto promised = Promised(header, table->num_points + num_bad);
  if (promised && *promised < table->num_points) {
    remarks->push_back(std::to_string(table->num_points - *promised) +
                       " lines behind the last point are ignored");
    table->num_points = static_cast<std::size_t>(*promised);
  }
  table->data = table->owned.data();
  RemarkOnCount(header, table->num_points, remarks);
  return true;
}

}  // namespace

bool ParsePcd(std::string_view bytes,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error) {
  *table = PointTable();
  PcdHeader header;
  if (!ReadHeader(bytes, &header, error) || !ReadFields(header, table, error)) return false;
  bool ok = false;
  switch (header.encoding) {
    case Encoding::kAscii:
      ok = ReadAscii(header, table, remarks, error);
      break;
    case Encoding::kBinary:
      ok = ReadBinary(header, table, remarks);
      break;
    case Encoding::kCompressed:
      ok = ReadCompressed(header, table, error);
      break;
  }
  RemovePadding(table);
  return ok;
}

}  // namespace radive
