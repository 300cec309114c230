// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "radive/io/bytes/byte_reader.h"

namespace radive {

// Reads the parts of a serialised ROS message in their order, of both generations:
//
//   ROS 1  packed little-endian values; a string is its uint32 length and its bytes
//   CDR    (ROS 2, OMG DDSI-RTPS 10.5) four bytes that say the byte order, then values that are
//          aligned to their size counted from the fifth byte; the length of a string includes a NUL
//
// As with ByteReader, reading beyond the end gives zeros and sets failed(), for good.
class RosMessageReader {
 public:
  enum class Encoding { kRos1, kCdr };

  // std_msgs/Header.
  struct Header {
    std::int64_t stamp_ns = 0;
    std::string_view frame_id;
  };

  RosMessageReader(std::string_view payload, Encoding encoding);

  Header ReadHeader();
  std::uint8_t U8() { return Number<std::uint8_t>(); }
  std::uint16_t U16() { return Number<std::uint16_t>(); }
  std::uint32_t U32() { return Number<std::uint32_t>(); }
  double F64() { return Number<double>(); }
  std::string_view String();
  std::string_view Bytes(std::uint64_t count) { return body_.Bytes(count); }

  bool is_big_endian() const { return is_big_endian_; }
  std::size_t remaining() const { return body_.remaining(); }
  bool failed() const { return failed_ || body_.failed(); }

 private:
  template <typename Type>
  Type Number() {
    const std::size_t alignment = std::min(sizeof(Type), largest_alignment_);
    if (encoding_ == Encoding::kCdr) {
      body_.Bytes((alignment - body_.position() % alignment) % alignment);
    }
    return body_.Number<Type>(is_big_endian_);
  }

  const Encoding encoding_;
  ByteReader body_;  // what positions and alignment are counted in
  bool is_big_endian_ = false;
  std::size_t largest_alignment_ = 8;
  bool failed_ = false;  // no known form
};

}  // namespace radive
