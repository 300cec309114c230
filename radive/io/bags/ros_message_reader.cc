// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/ros_message_reader.h"

namespace radive {

RosMessageReader::RosMessageReader(std::string_view payload, Encoding encoding)
    : encoding_(encoding), body_(payload) {
  if (encoding_ == Encoding::kRos1) return;
  // Byte 1: 0 and 1 plain CDR, 6 and 7 that of XTypes 2, which differs in 8-byte values only; the
  // odd ones are little-endian. Bytes 2 and 3 are options.
  const int kind = payload.size() < 4 || payload[0] != 0 ? -1 : payload[1];
  failed_ = kind != 0 && kind != 1 && kind != 6 && kind != 7;
  is_big_endian_ = kind % 2 == 0;
  if (kind >= 6) largest_alignment_ = 4;
  body_ = ByteReader(failed_ ? std::string_view() : payload.substr(4));
}

std::string_view RosMessageReader::String() {
  std::string_view text = Bytes(U32());
  if (encoding_ == Encoding::kCdr && !text.empty() && text.back() == '\0') text.remove_suffix(1);
  return text;
}

RosMessageReader::Header RosMessageReader::ReadHeader() {
  Header header;
  if (encoding_ == Encoding::kRos1) U32();  // the sequence number, which ROS 2 dropped
  const std::uint32_t seconds = U32();
  // ROS 2 counts the seconds with a sign; as unsigned ones they go beyond 2038 in ROS 1.
  header.stamp_ns = encoding_ == Encoding::kCdr
                        ? static_cast<std::int64_t>(static_cast<std::int32_t>(seconds))
                        : static_cast<std::int64_t>(seconds);
  header.stamp_ns = header.stamp_ns * 1000000000 + U32();
  header.frame_id = String();
  return header;
}

}  // namespace radive
