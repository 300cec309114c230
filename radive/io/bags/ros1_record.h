// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "radive/io/bytes/random_access_file.h"

namespace radive {

// First line of a ROS 1 bag.
inline constexpr std::string_view kRos1Magic = "#ROSBAG V2.0\n";

// What a record of a ROS 1 bag is, the value of its header field "op".
enum class Ros1Op : std::uint8_t {
  kMessage = 0x02,
  kBagHeader = 0x03,
  kIndex = 0x04,
  kChunk = 0x05,
  kChunkInfo = 0x06,
  kConnection = 0x07
};

// The value of field `name` in a header block: repeated "u32 length, NAME=VALUE", in any order.
// Nothing when there is none.
std::optional<std::string_view> Ros1Field(std::string_view header, std::string_view name);

// A record of a ROS 1 bag: "u32 length, header, u32 length, data".
struct Ros1Record {
  std::string header;
  std::uint64_t data_position = 0;
  std::uint64_t data_size = 0;  // as the record says, which may be beyond the end of the file

  Ros1Op op() const { return static_cast<Ros1Op>(Unsigned("op", 1).value_or(0)); }
  std::uint64_t end() const { return data_position + data_size; }

  // A little-endian field of `size` bytes; nothing when there is none of that size.
  std::optional<std::uint64_t> Unsigned(std::string_view name, std::size_t size) const;
  // A field of seconds and nanoseconds, a uint32 each [ns].
  std::optional<std::int64_t> Time(std::string_view name) const;
};

// Reads the header of the record at `position`. False when it is cut or damaged.
bool ReadRos1Record(RandomAccessFile* file, std::uint64_t position, Ros1Record* record);

// The time in 8 bytes: seconds and nanoseconds, a uint32 each [ns].
std::int64_t Ros1Time(std::uint64_t bytes);

}  // namespace radive
