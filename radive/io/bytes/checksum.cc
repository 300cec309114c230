// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <optional>
#include <string>

namespace radive {
namespace {

constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;  // [bytes]

}  // namespace

std::uint32_t Crc32(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::optional<std::uint32_t> Crc32(RandomAccessFile* file) {
  std::uint32_t sum = 0;
  std::string buffer;
  for (std::uint64_t position = 0; position < file->size();) {
    const std::uint64_t count = std::min(kPiece, file->size() - position);
    const auto bytes = file->Read(position, count, &buffer);
    if (!bytes) return std::nullopt;
    sum = Crc32(*bytes, sum);
    position += count;
  }
  return sum;
}

}  // namespace radive
