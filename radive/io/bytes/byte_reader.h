// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "radive/io/bytes/byte_order.h"

namespace radive {

// A cursor over bytes whose content nobody vouches for. Integers are little-endian. Reading beyond
// the end gives zeros or an empty view and sets failed(), for good; nothing is ever read outside of
// the bytes. So a whole structure can be read first and checked once. Holds a view: the bytes must
// outlive it.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t U8() { return Number<std::uint8_t>(); }
  std::uint16_t U16() { return Number<std::uint16_t>(); }
  std::uint32_t U32() { return Number<std::uint32_t>(); }
  std::uint64_t U64() { return Number<std::uint64_t>(); }

  // The next number of that type.
  template <typename Type>
  Type Number(bool is_big_endian = false) {
    const std::string_view bytes = Bytes(sizeof(Type));
    return failed_ ? Type() : NumberAt<Type>(bytes.data(), is_big_endian);
  }

  // The next `count` bytes.
  std::string_view Bytes(std::uint64_t count) {
    if (failed_ || count > remaining()) {
      failed_ = true;
      return {};
    }
    const std::string_view bytes = bytes_.substr(position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return bytes;
  }

  // Bytes behind their number, which is a uint32.
  std::string_view String() { return Bytes(U32()); }

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  bool AtEnd() const { return remaining() == 0; }
  bool failed() const { return failed_; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
  bool failed_ = false;
};

}  // namespace radive
