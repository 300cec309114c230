// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

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
  std::uint8_t U8() { return static_cast<std::uint8_t>(Integer(1)); }
  std::uint16_t U16() { return static_cast<std::uint16_t>(Integer(2)); }
  std::uint32_t U32() { return static_cast<std::uint32_t>(Integer(4)); }
  double F64();
  std::string_view String();
  std::string_view Bytes(std::uint64_t count);

  bool is_big_endian() const { return is_big_endian_; }
  std::size_t remaining() const { return body_.size() - position_; }
  bool failed() const { return failed_; }

 private:
  std::uint64_t Integer(std::size_t size);

  const Encoding encoding_;
  std::string_view body_;  // what positions and alignment are counted in
  bool is_big_endian_ = false;
  std::size_t largest_alignment_ = 8;
  std::size_t position_ = 0;
  bool failed_ = false;
};

}  // namespace radive
