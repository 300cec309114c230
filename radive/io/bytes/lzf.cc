// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/lzf.h"

#include <algorithm>
#include <cstdint>

namespace radive {
namespace {

constexpr std::size_t kLongestLiteral = 32;
constexpr std::size_t kLongestRepeat = 264;
constexpr std::size_t kFarthest = 8192;

std::size_t Byte(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

void AppendLiterals(std::string_view bytes, std::string* packed) {
  while (!bytes.empty()) {
    const std::size_t count = std::min(bytes.size(), kLongestLiteral);
    *packed += static_cast<char>(count - 1);
    packed->append(bytes.substr(0, count));
    bytes.remove_prefix(count);
  }
}

void AppendRepeat(std::size_t length, std::size_t distance, std::string* packed) {
  const std::size_t offset = distance - 1;
  const std::size_t code = length - 2;
  *packed += static_cast<char>(std::min<std::size_t>(code, 7) << 5 | offset >> 8);
  if (code >= 7) *packed += static_cast<char>(code - 7);
  *packed += static_cast<char>(offset & 0xFF);
}

}  // namespace

bool UnpackLzf(std::string_view packed,
               std::size_t size,
               std::vector<char>* unpacked,
               std::string* error) {
  unpacked->clear();
  // Three bytes give at most kLongestRepeat.
  if (size / kLongestRepeat > packed.size()) {
    *error =
        std::to_string(packed.size()) + " compressed bytes cannot hold " + std::to_string(size);
    return false;
  }
  unpacked->resize(size);
  char* const out = unpacked->data();
  std::size_t done = 0;
  std::size_t i = 0;
  const auto fail = [&](const char* what) {
    *error = "compressed data: " + std::string(what) + " at byte " + std::to_string(i);
    unpacked->clear();
    return false;
  };
  while (i < packed.size()) {
    const std::size_t control = Byte(packed, i++);
    if (control < 32) {
      const std::size_t count = control + 1;
      if (count > packed.size() - i) return fail("the end is missing");
      if (count > size - done) return fail("more data than declared");
      std::copy_n(packed.data() + i, count, out + done);
      i += count;
      done += count;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    if (length == 9) {
      if (i == packed.size()) return fail("the end is missing");
      length += Byte(packed, i++);
    }
    if (i == packed.size()) return fail("the end is missing");
    const std::size_t distance = ((control & 31) << 8 | Byte(packed, i++)) + 1;
    if (distance > done) return fail("a reference before the start");
    if (length > size - done) return fail("more data than declared");
    for (const std::size_t end = done + length; done < end; ++done) {
      out[done] = out[done - distance];  // may overlap, byte by byte
    }
  }
  if (done != size) return fail("less data than declared");
  return true;
}

std::string PackLzf(std::string_view bytes) {
  std::string packed;
  std::vector<std::size_t> last(std::size_t{1} << 16, 0);  // place + 1 of three bytes, by hash
  std::size_t literals = 0;                                // first byte not yet packed
  std::size_t i = 0;
  while (i + 3 <= bytes.size()) {
    const std::uint32_t three = static_cast<std::uint32_t>(
        Byte(bytes, i) << 16 | Byte(bytes, i + 1) << 8 | Byte(bytes, i + 2));
    std::size_t& seen = last[(three * 2654435761U) >> 16];
    const std::size_t before = seen;
    seen = i + 1;
    std::size_t length = 0;
    if (before != 0 && i - (before - 1) <= kFarthest) {
      const std::size_t most = std::min(kLongestRepeat, bytes.size() - i);
      while (length < most && bytes[before - 1 + length] == bytes[i + length]) ++length;
    }
    if (length < 3) {
      ++i;
      continue;
    }
    AppendLiterals(bytes.substr(literals, i - literals), &packed);
    AppendRepeat(length, i - (before - 1), &packed);
    i += length;
    literals = i;
  }
  AppendLiterals(bytes.substr(literals), &packed);
  return packed;
}

}  // namespace radive
