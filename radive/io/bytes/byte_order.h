// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace radive {

// Numbers in files and messages, whatever the byte order of this machine: the only place where they
// are put together from bytes, or taken apart. `Number`: an integer, float or double.

// The unsigned integer with as many bytes as `Number`.
template <typename Number>
using BitsOf = std::conditional_t<
    sizeof(Number) == 1,
    std::uint8_t,
    std::conditional_t<sizeof(Number) == 2,
                       std::uint16_t,
                       std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>;

// The number at `bytes`, sizeof(Number) of them, which need not be aligned.
template <typename Number>
Number NumberAt(const char* bytes, bool is_big_endian = false) {
  static_assert(std::is_arithmetic_v<Number> && sizeof(BitsOf<Number>) == sizeof(Number));
  // Compilers make one load, and a swap where it takes one, of the loop.
  BitsOf<Number> bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t place = is_big_endian ? i : sizeof(Number) - 1 - i;
    bits = static_cast<BitsOf<Number>>((static_cast<std::uint64_t>(bits) << 8) |
                                       static_cast<unsigned char>(bytes[place]));
  }
  Number value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// The other way round, for writers: appends the bytes of `value`, little-endian.
template <typename Number>
void AppendLittleEndian(Number value, std::string* bytes) {
  static_assert(std::is_arithmetic_v<Number> && sizeof(BitsOf<Number>) == sizeof(Number));
  BitsOf<Number> bits;
  std::memcpy(&bits, &value, sizeof(value));
  char raw[sizeof(Number)];
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    raw[i] = static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xFFU);
  }
  bytes->append(raw, sizeof(Number));
}

// The bytes of `value`, little-endian.
template <typename Number>
std::string LittleEndian(Number value) {
  std::string bytes;
  AppendLittleEndian(value, &bytes);
  return bytes;
}

}  // namespace radive
