// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/ros1_record.h"

#include "radive/io/bytes/byte_reader.h"

namespace radive {
namespace {

// Headers hold a few numbers and the name of a topic [bytes].
constexpr std::uint32_t kLargestHeader = 1 << 16;

}  // namespace

std::optional<std::string_view> Ros1Field(std::string_view header, std::string_view name) {
  ByteReader reader(header);
  while (!reader.AtEnd()) {
    const std::string_view field = reader.String();
    if (reader.failed()) return std::nullopt;
    if (field.size() > name.size() && field[name.size()] == '=' &&
        field.substr(0, name.size()) == name) {
      return field.substr(name.size() + 1);
    }
  }
  return std::nullopt;
}

std::optional<std::uint64_t> Ros1Record::Unsigned(std::string_view name, std::size_t size) const {
  const std::optional<std::string_view> value = Ros1Field(header, name);
  if (!value || value->size() != size) return std::nullopt;
  ByteReader reader(*value);
  return size == 1 ? reader.U8() : size == 4 ? reader.U32() : reader.U64();
}

std::optional<std::int64_t> Ros1Record::Time(std::string_view name) const {
  const std::optional<std::uint64_t> bytes = Unsigned(name, 8);
  if (!bytes) return std::nullopt;
  return Ros1Time(*bytes);
}

bool ReadRos1Record(RandomAccessFile* file, std::uint64_t position, Ros1Record* record) {
  std::string buffer;
  const auto size = file->Read(position, 4, &buffer);
  if (!size) return false;
  const std::uint32_t header_size = ByteReader(*size).U32();
  if (header_size > kLargestHeader) return false;
  // The header and the length of the data behind it.
  const auto header = file->Read(position + 4, header_size + std::uint64_t{4}, &buffer);
  if (!header) return false;
  record->header.assign(header->substr(0, header_size));
  record->data_position = position + 8 + header_size;
  record->data_size = ByteReader(header->substr(header_size)).U32();
  return Ros1Field(record->header, "op").has_value();
}

std::int64_t Ros1Time(std::uint64_t bytes) {
  return static_cast<std::int64_t>(bytes & 0xFFFFFFFFu) * 1000000000 +
         static_cast<std::int64_t>(bytes >> 32);
}

}  // namespace radive
