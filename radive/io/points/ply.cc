// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/ply.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/number_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr std::size_t kMostProperties = 1000;

struct Property {
  std::string name;
  NumericType type = NumericType::kFloat32;  // of the value, or of the items of a list
  bool is_list = false;
  NumericType count_type = NumericType::kUint8;
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  bool is_ascii = false;
  bool is_big_endian = false;
  std::vector<Element> elements;
  std::string_view payload;
};

std::optional<NumericType> TypeOfName(std::string_view name) {
  constexpr std::pair<std::string_view, NumericType> kNames[] = {
      {"float", NumericType::kFloat32},  {"float32", NumericType::kFloat32},
      {"double", NumericType::kFloat64}, {"float64", NumericType::kFloat64},
      {"bool", NumericType::kUint8},     {"char", NumericType::kInt8},
      {"int8", NumericType::kInt8},      {"uchar", NumericType::kUint8},
      {"uint8", NumericType::kUint8},    {"short", NumericType::kInt16},
      {"int16", NumericType::kInt16},    {"ushort", NumericType::kUint16},
      {"uint16", NumericType::kUint16},  {"int", NumericType::kInt32},
      {"int32", NumericType::kInt32},    {"uint", NumericType::kUint32},
      {"uint32", NumericType::kUint32},  {"int64", NumericType::kInt64},
      {"uint64", NumericType::kUint64},
  };
  const std::string lower_case = LowerCase(name);
  for (const auto& [known, type] : kNames) {
    if (known == lower_case) return type;
  }
  return std::nullopt;
}

bool ReadProperty(std::string_view rest, PlyHeader* header) {
  if (header->elements.empty()) return false;
  Property property;
  std::string_view word = TakeWord(&rest);
  property.is_list = word == "list";
  if (property.is_list) {
    const auto count_type = TypeOfName(TakeWord(&rest));
    if (!count_type) return false;
    property.count_type = *count_type;
    word = TakeWord(&rest);
  }
  const auto type = TypeOfName(word);
  property.name = TakeWord(&rest);
  auto& properties = header->elements.back().properties;
  if (!type || property.name.empty() || properties.size() == kMostProperties) return false;
  property.type = *type;
  properties.push_back(std::move(property));
  return true;
}

// Reads one line; sets `is_last` at end_header. Case does not matter, and keys that are not known
// are left to whoever wrote them.
bool ReadHeaderLine(std::string_view line, PlyHeader* header, bool* is_last) {
  std::string_view rest = line;
  const std::string key = LowerCase(TakeWord(&rest));
  if (key == "format") {
    const std::string format = LowerCase(TakeWord(&rest));
    header->is_ascii = format == "ascii";
    header->is_big_endian = format == "binary_big_endian";
    return header->is_ascii || header->is_big_endian || format == "binary_little_endian";
  }
  if (key == "element") {
    Element element;
    element.name = TakeWord(&rest);
    const auto count = ParseCount(TakeWord(&rest));
    if (!count || element.name.empty() || header->elements.size() == kMostProperties) return false;
    element.count = *count;
    header->elements.push_back(std::move(element));
    return true;
  }
  if (key == "property") return ReadProperty(rest, header);
  *is_last = key == "end_header";
  return true;
}

bool ReadHeader(std::string_view bytes, PlyHeader* header, std::string* error) {
  bytes = WithoutByteOrderMark(bytes);
  for (int number = 1;; ++number) {
    const std::size_t end = bytes.find('\n');
    const std::string_view line = bytes.substr(0, end);
    std::string_view rest = line;
    bool is_last = false;
    const bool is_good =
        end != std::string_view::npos && (number == 1 ? LowerCase(TakeWord(&rest)) == "ply"
                                                      : ReadHeaderLine(line, header, &is_last));
    if (!is_good) {
      *error = "line " + std::to_string(number) + ": expected " +
               (number == 1 ? "'ply'"
                            : "a line of a PLY header (format, element, property with a known "
                              "type, end_header)") +
               ", found " + Quoted(line);
      return false;
    }
    bytes.remove_prefix(end + 1);
    if (is_last) break;
  }
  header->payload = bytes;
  return true;
}

// Takes the properties of one element off the front of the payload; those that are no lists go to
// `record`, as the table has them, unless it is null. False at the end of the data.
class ElementReader {
 public:
  explicit ElementReader(const PlyHeader& header) : header_(header), rest_(header.payload) {}

  bool Read(const Element& element, std::string* record) {
    for (const Property& property : element.properties) {
      const bool ok = header_.is_ascii ? ReadText(property, record) : ReadBytes(property, record);
      if (!ok) return false;
    }
    return true;
  }

  std::string_view* rest() { return &rest_; }

 private:
  bool ReadText(const Property& property, std::string* record) {
    std::optional<double> value = ParseDouble(TakeWord(&rest_));
    if (!value) return false;
    if (!property.is_list) {
      if (record == nullptr) return true;
      if (property.type == NumericType::kFloat32) {
        AppendLittleEndian(static_cast<float>(*value), record);
      } else {
        AppendLittleEndian(*value, record);
      }
      return true;
    }
    // Each item takes a word, so that a false count ends with the text.
    for (double i = 0; i < *value; ++i) {
      if (TakeWord(&rest_).empty()) return false;
    }
    return true;
  }

  bool ReadBytes(const Property& property, std::string* record) {
    std::size_t size = SizeOf(property.is_list ? property.count_type : property.type);
    if (rest_.size() < size) return false;
    if (!property.is_list) {
      if (record != nullptr) record->append(rest_.substr(0, size));
      rest_.remove_prefix(size);
      return true;
    }
    const double count = ReadNumber(rest_.data(), property.count_type, header_.is_big_endian);
    rest_.remove_prefix(size);
    if (!(count >= 0.0)) return false;
    if (count * static_cast<double>(SizeOf(property.type)) > static_cast<double>(rest_.size())) {
      return false;
    }
    rest_.remove_prefix(static_cast<std::size_t>(count) * SizeOf(property.type));
    return true;
  }

  const PlyHeader& header_;
  std::string_view rest_;
};

bool HasLists(const Element& element) {
  for (const Property& property : element.properties) {
    if (property.is_list) return true;
  }
  return false;
}

// Takes `element` off the data. False when they end before.
bool SkipElement(const Element& element, bool is_ascii, ElementReader* reader) {
  if (element.properties.empty()) return true;
  if (!is_ascii && !HasLists(element)) {
    std::size_t stride = 0;
    for (const Property& property : element.properties) stride += SizeOf(property.type);
    std::string_view* const rest = reader->rest();
    if (element.count > rest->size() / stride) return false;
    rest->remove_prefix(static_cast<std::size_t>(element.count) * stride);
    return true;
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (!reader->Read(element, nullptr)) return false;
  }
  return true;
}

void ReadVertices(const PlyHeader& header,
                  const Element& vertex,
                  ElementReader* reader,
                  PointTable* table) {
  for (const Property& property : vertex.properties) {
    if (property.is_list) continue;
    const bool as_double = header.is_ascii && property.type != NumericType::kFloat32;
    table->AddField(property.name, as_double ? NumericType::kFloat64 : property.type);
  }
  table->is_big_endian = header.is_big_endian && !header.is_ascii;
  if (table->stride == 0) return;
  if (!header.is_ascii && !HasLists(vertex)) {
    const std::size_t fit = reader->rest()->size() / table->stride;
    table->data = reader->rest()->data();
    table->num_points = vertex.count < fit ? static_cast<std::size_t>(vertex.count) : fit;
    reader->rest()->remove_prefix(table->num_points * table->stride);
    return;
  }
  std::string record;
  while (table->num_points < vertex.count) {
    record.clear();
    if (!reader->Read(vertex, &record)) break;
    table->owned.insert(table->owned.end(), record.begin(), record.end());
    ++table->num_points;
  }
  table->data = table->owned.data();
}

}  // namespace

bool ParsePly(std::string_view bytes,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error) {
  *table = PointTable();
  PlyHeader header;
  if (!ReadHeader(bytes, &header, error)) return false;
  ElementReader reader(header);
  for (const Element& element : header.elements) {
    if (LowerCase(element.name) != "vertex") {
      if (SkipElement(element, header.is_ascii, &reader)) continue;
      *error = "the data end within the element " + Quoted(element.name) + ", before the vertices";
      return false;
    }
    ReadVertices(header, element, &reader, table);
    if (table->num_points < element.count) {
      remarks->push_back("the header promises " + std::to_string(element.count) +
                         " points, the data hold " + std::to_string(table->num_points));
    } else if (&element == &header.elements.back() && table->stride > 0) {
      std::string_view rest = *reader.rest();
      if (header.is_ascii) {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
      }
      if (!rest.empty()) {
        remarks->push_back(std::to_string(rest.size()) +
                           " bytes behind the last point are ignored");
      }
    }
    return true;
  }
  *error = "the PLY header has no element vertex";
  return false;
}

}  // namespace radive
