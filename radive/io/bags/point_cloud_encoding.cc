// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/point_cloud_encoding.h"

#include <glog/logging.h>

#include <array>
#include <cstdint>
#include <utility>

#include "radive/io/bytes/byte_order.h"

namespace radive {
namespace {

constexpr std::array<const char*, 5> kFields = {"x", "y", "z", "doppler", "power"};
constexpr std::uint32_t kPointStep = 4 * kFields.size();
constexpr std::uint8_t kFloat32 = 7;  // PointField.FLOAT32
constexpr std::int64_t kSecond = 1000000000;

// Appends the parts of a message; see RosMessageReader for the two forms.
class MessageEncoder {
 public:
  explicit MessageEncoder(bool is_cdr) : is_cdr_(is_cdr) {
    if (is_cdr_) bytes_.assign("\x00\x01\x00\x00", 4);
  }

  void U8(std::uint8_t value) { AppendLittleEndian(value, &bytes_); }
  void U32(std::uint64_t value) {
    while (is_cdr_ && bytes_.size() % 4 != 0) bytes_ += '\0';
    AppendLittleEndian(static_cast<std::uint32_t>(value), &bytes_);
  }
  void String(const std::string& text) {
    U32(text.size() + (is_cdr_ ? 1 : 0));
    bytes_ += text;
    if (is_cdr_) bytes_ += '\0';
  }
  void Float(double value) { AppendLittleEndian(static_cast<float>(value), &bytes_); }

  void Header(std::int64_t stamp_ns, const std::string& frame_id) {
    // The nanoseconds count from the second before.
    const std::int64_t nanoseconds = ((stamp_ns % kSecond) + kSecond) % kSecond;
    if (!is_cdr_) U32(0);  // the sequence number
    U32(static_cast<std::uint64_t>((stamp_ns - nanoseconds) / kSecond));
    U32(static_cast<std::uint64_t>(nanoseconds));
    String(frame_id);
  }

  std::string Take() { return std::move(bytes_); }

 private:
  const bool is_cdr_;
  std::string bytes_;
};

}  // namespace

std::string EncodePointCloud2(const RadarScan& scan,
                              std::string_view encoding,
                              const std::string& frame_id) {
  CHECK(encoding == "ros1" || encoding == "cdr") << encoding;
  MessageEncoder message(encoding == "cdr");
  const std::uint64_t num_points = scan.returns.size();
  message.Header(scan.stamp_ns, frame_id);
  message.U32(1);  // height
  message.U32(num_points);
  message.U32(kFields.size());
  for (std::size_t i = 0; i < kFields.size(); ++i) {
    message.String(kFields[i]);
    message.U32(4 * i);
    message.U8(kFloat32);
    message.U32(1);  // count
  }
  message.U8(0);  // is_bigendian
  message.U32(kPointStep);
  message.U32(kPointStep * num_points);
  message.U32(kPointStep * num_points);
  for (const RadarReturn& point : scan.returns) {
    for (int axis = 0; axis < 3; ++axis) message.Float(point.position[axis]);
    message.Float(point.doppler);
    message.Float(point.power);
  }
  message.U8(1);  // is_dense
  return message.Take();
}

std::string PointCloud2Definition(std::string_view encoding) {
  const bool is_ros1 = encoding == "ros1";
  const std::string separator = "\n" + std::string(80, '=') + "\n";
  return std::string(is_ros1 ? "Header" : "std_msgs/Header") +
         " header\n"
         "uint32 height\n"
         "uint32 width\n" +
         (is_ros1 ? "PointField[] fields\n" : "sensor_msgs/PointField[] fields\n") +
         "bool is_bigendian\n"
         "uint32 point_step\n"
         "uint32 row_step\n"
         "uint8[] data\n"
         "bool is_dense" +
         separator + "MSG: std_msgs/Header\n" + (is_ros1 ? "uint32 seq\n" : "") +
         (is_ros1 ? "time stamp\n" : "builtin_interfaces/Time stamp\n") + "string frame_id" +
         (is_ros1 ? "" : separator + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec") +
         separator +
         "MSG: sensor_msgs/PointField\n"
         "uint8 INT8=1\n"
         "uint8 UINT8=2\n"
         "uint8 INT16=3\n"
         "uint8 UINT16=4\n"
         "uint8 INT32=5\n"
         "uint8 UINT32=6\n"
         "uint8 FLOAT32=7\n"
         "uint8 FLOAT64=8\n"
         "string name\n"
         "uint32 offset\n"
         "uint8 datatype\n"
         "uint32 count\n";
}

}  // namespace radive
