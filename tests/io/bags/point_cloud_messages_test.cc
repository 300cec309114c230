// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/point_cloud_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bytes/byte_order.h"
#include "radive/io/scans/point_converter.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const MessageTopic kRos1Cloud2 = {"/a", "sensor_msgs/PointCloud2", "ros1", {}};
const MessageTopic kCdrCloud2 = {"/a", "sensor_msgs/msg/PointCloud2", "cdr", {}};
const MessageTopic kRos1Cloud = {"/a", "sensor_msgs/PointCloud", "ros1", {}};
const MessageTopic kCdrCloud = {"/a", "sensor_msgs/msg/PointCloud", "cdr", {}};

// Puts a message together, byte by byte: the values of each call follow each other without gaps.
std::string Bytes(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}
std::string F32(float value) {
  std::string bytes;
  AppendLittleEndian(value, &bytes);
  return bytes;
}
std::string Text(const std::string& text) {
  return LittleEndian<std::uint32_t>(static_cast<std::uint32_t>(text.size())) + text;
}

// What differs from message to message.
struct Cloud2 {
  std::uint32_t height = 1;
  std::uint32_t width = 1;
  std::string fields;
  std::uint32_t num_fields = 0;
  bool is_big_endian = false;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
  std::string data;

  void Add(const std::string& name, std::uint32_t offset, int datatype, std::uint32_t count = 1) {
    fields += Text(name) + LittleEndian<std::uint32_t>(offset) + Bytes({datatype}) +
              LittleEndian<std::uint32_t>(count);
    ++num_fields;
  }
  // As ROS 1 writes it: 7 s and 8 ns, frame "fr".
  std::string Ros1() const {
    return LittleEndian<std::uint32_t>(9) + LittleEndian<std::uint32_t>(7) +
           LittleEndian<std::uint32_t>(8) + Text("fr") + LittleEndian<std::uint32_t>(height) +
           LittleEndian<std::uint32_t>(width) + LittleEndian<std::uint32_t>(num_fields) + fields +
           Bytes({is_big_endian ? 1 : 0}) + LittleEndian<std::uint32_t>(point_step) +
           LittleEndian<std::uint32_t>(row_step) + Text(data) + Bytes({1});
  }
};

// x, y, z, doppler as float32, 16 bytes a point.
Cloud2 FourFloats() {
  Cloud2 cloud;
  cloud.Add("x", 0, 7);
  cloud.Add("y", 4, 7);
  cloud.Add("z", 8, 7);
  cloud.Add("doppler", 12, 7);
  cloud.point_step = cloud.row_step = 16;
  cloud.data = F32(1) + F32(2) + F32(3) + F32(-4);
  return cloud;
}

RadarScan Read(const std::string& payload, const MessageTopic& topic) {
  PointTable table;
  RadarScan scan;
  std::vector<std::string> remarks;
  std::string error;
  EXPECT_TRUE(ReadPointCloud(payload, topic, &table, &remarks, &error)) << error;
  EXPECT_TRUE(PointConverter(InputOptions()).Convert(table, &scan, &error)) << error;
  return scan;
}

std::string ErrorOf(const std::string& payload, const MessageTopic& topic) {
  PointTable table;
  std::vector<std::string> remarks;
  std::string error;
  EXPECT_FALSE(ReadPointCloud(payload, topic, &table, &remarks, &error));
  EXPECT_EQ(table.num_points, 0u);
  return error;
}

TEST(PointCloud2, IsReadFromRos1) {
  const std::string payload = FourFloats().Ros1();
  const RadarScan scan = Read(payload, kRos1Cloud2);
  ASSERT_EQ(scan.returns.size(), 1u);
  EXPECT_EQ(scan.returns[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scan.returns[0].doppler, -4.0);
  EXPECT_TRUE(std::isnan(scan.returns[0].power));
  std::int64_t stamp_ns = 0;
  EXPECT_TRUE(ReadPointCloudStamp(payload, kRos1Cloud2, &stamp_ns));
  EXPECT_EQ(stamp_ns, 7000000008);
}

// Strings end in NUL and numbers are aligned: worked out by hand from the fifth byte on.
TEST(PointCloud2, IsReadFromCdr) {
  const std::string payload =
      Bytes({0, 1, 0, 0}) + LittleEndian<std::uint32_t>(7) + LittleEndian<std::uint32_t>(8) +
      Text(std::string("fr\0", 3)) + Bytes({0}) +  // 16
      LittleEndian<std::uint32_t>(1) + LittleEndian<std::uint32_t>(2) +
      LittleEndian<std::uint32_t>(3) +  // 28
      Text(std::string("x\0", 2)) + Bytes({0, 0}) + LittleEndian<std::uint32_t>(4) +
      Bytes({7, 0, 0, 0}) + LittleEndian<std::uint32_t>(1) + Text(std::string("y\0", 2)) +
      Bytes({0, 0}) + LittleEndian<std::uint32_t>(0) + Bytes({7, 0, 0, 0}) +
      LittleEndian<std::uint32_t>(1) + Text(std::string("v_r\0", 4)) +
      LittleEndian<std::uint32_t>(8) + Bytes({3, 0, 0, 0}) + LittleEndian<std::uint32_t>(1) +
      Bytes({0, 0, 0, 0}) + LittleEndian<std::uint32_t>(12) + LittleEndian<std::uint32_t>(24) +
      LittleEndian<std::uint32_t>(24) + F32(5) + F32(6) + Bytes({0xFE, 0xFF, 9, 9}) + F32(7) +
      F32(8) + Bytes({3, 0, 9, 9}) + Bytes({1});
  const RadarScan scan = Read(payload, kCdrCloud2);
  ASSERT_EQ(scan.returns.size(), 2u);
  EXPECT_EQ(scan.returns[0].position, Eigen::Vector3d(6, 5, 0));
  EXPECT_EQ(scan.returns[0].doppler, -2.0);
  EXPECT_EQ(scan.returns[1].position, Eigen::Vector3d(8, 7, 0));
  EXPECT_EQ(scan.returns[1].doppler, 3.0);
  EXPECT_TRUE(scan.is_planar);
  std::int64_t stamp_ns = 0;
  EXPECT_TRUE(ReadPointCloudStamp(payload, kCdrCloud2, &stamp_ns));
  EXPECT_EQ(stamp_ns, 7000000008);
}

TEST(PointCloud2, BigEndianCdrIsReadToo) {
  std::string payload = Bytes({0, 0, 0, 0}) + Bytes({0xFF, 0xFF, 0xFF, 0xFF}) + Bytes({0, 0, 0, 5});
  payload += Bytes({0, 0, 0, 1, 0});
  std::int64_t stamp_ns = 0;
  EXPECT_TRUE(ReadPointCloudStamp(payload, kCdrCloud2, &stamp_ns));
  EXPECT_EQ(stamp_ns, -1000000000 + 5);  // ROS 2 counts seconds with a sign
  payload[1] = 2;                        // a parameter list, which no ROS message is
  EXPECT_FALSE(ReadPointCloudStamp(payload, kCdrCloud2, &stamp_ns));
}

TEST(PointCloud2, EveryTypeOfNumberAndByteOrder) {
  Cloud2 cloud;
  cloud.is_big_endian = true;
  cloud.Add("x", 0, 8);            // float64
  cloud.Add("y", 8, 1);            // int8
  cloud.Add("z", 9, 4);            // uint16
  cloud.Add("velocity", 11, 5);    // int32
  cloud.Add("intensity", 15, 6);   // uint32
  cloud.Add("of_tomorrow", 0, 9);  // no type that we know
  cloud.point_step = cloud.row_step = 20;
  cloud.data = Bytes({0xC0, 0x04, 0, 0, 0, 0, 0, 0}) +  // -2.5
               Bytes({0xFB}) + Bytes({1, 2}) + Bytes({0xFF, 0xFF, 0xFF, 0x00}) +
               Bytes({0x80, 0, 0, 1}) + Bytes({7});
  const RadarScan scan = Read(cloud.Ros1(), kRos1Cloud2);
  ASSERT_EQ(scan.returns.size(), 1u);
  EXPECT_EQ(scan.returns[0].position, Eigen::Vector3d(-2.5, -5, 258));
  EXPECT_EQ(scan.returns[0].doppler, -256.0);
  EXPECT_EQ(scan.returns[0].power, 2147483649.0);
}

TEST(PointCloud2, RowsMayHaveGapsBetweenThem) {
  Cloud2 cloud = FourFloats();
  const std::string point = cloud.data;
  cloud.height = 2;
  cloud.row_step = 20;
  cloud.data = point + "gap!" + F32(5) + F32(6) + F32(7) + F32(8) + "gap!";
  const RadarScan scan = Read(cloud.Ros1(), kRos1Cloud2);
  ASSERT_EQ(scan.returns.size(), 2u);
  EXPECT_EQ(scan.returns[1].position, Eigen::Vector3d(5, 6, 7));
  EXPECT_EQ(scan.returns[1].doppler, 8.0);
}

TEST(PointCloud2, SlopsThatDriversMakeAreForgiven) {
  Cloud2 cloud = FourFloats();
  cloud.row_step = 0;  // one row needs none
  EXPECT_EQ(Read(cloud.Ros1(), kRos1Cloud2).returns.size(), 1u);
  cloud = FourFloats();
  cloud.fields.clear();
  cloud.num_fields = 0;
  for (const char* name : {"x", "y", "z", "doppler"}) {
    cloud.Add(name, 4 * cloud.num_fields, 7, /*count=*/0);
  }
  EXPECT_EQ(Read(cloud.Ros1(), kRos1Cloud2).returns[0].doppler, -4.0);
  cloud = Cloud2();
  cloud.width = 0;
  PointTable table;
  std::vector<std::string> remarks;
  std::string error;
  EXPECT_TRUE(ReadPointCloud(cloud.Ros1(), kRos1Cloud2, &table, &remarks, &error)) << error;
  EXPECT_EQ(table.num_points, 0u);
}

// The remarks on a message of four points in two rows of two, x = 1, 2, 3, 4; `num_points` are
// read.
std::vector<std::string> RemarksOn(const Cloud2& cloud, const std::vector<double>& expected_x) {
  PointTable table;
  std::vector<std::string> remarks;
  std::string error;
  EXPECT_TRUE(ReadPointCloud(cloud.Ros1(), kRos1Cloud2, &table, &remarks, &error)) << error;
  std::vector<double> x;
  for (std::size_t i = 0; i < table.num_points; ++i) {
    x.push_back(ReadNumber(table.data + i * table.stride, NumericType::kFloat32, false));
  }
  EXPECT_EQ(x, expected_x);
  return remarks;
}

Cloud2 TwoRows() {
  Cloud2 cloud;
  cloud.Add("x", 0, 7);
  cloud.Add("y", 4, 7);
  cloud.width = cloud.height = 2;
  cloud.point_step = 8;
  cloud.row_step = 16;
  cloud.data = F32(1) + F32(0) + F32(2) + F32(0) + F32(3) + F32(0) + F32(4) + F32(0);
  return cloud;
}

// All drivers below write two rows of 16 bytes each, one behind the other.
TEST(PointCloud2, AWrongRowStepIsReplacedByWhatFits) {
  Cloud2 cloud = TwoRows();
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}), IsEmpty());
  cloud.row_step = 0;
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}), IsEmpty()) << "not set is not wrong";
  for (const std::uint32_t wrong : {2u, 8u, 24u, 32u, 0xFFFFFFFFu}) {
    cloud.row_step = wrong;
    EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}),
                ElementsAre(HasSubstr("a row_step of " + std::to_string(wrong) +
                                      " bytes does not fit 32 bytes of data for 2 rows of 2 "
                                      "points; 16 bytes are taken")));
  }
  // Rows with 4 bytes behind them, and a row_step that forgets these.
  cloud.data.insert(16, F32(9));
  cloud.data += F32(9);
  cloud.row_step = 20;
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}), IsEmpty());
  cloud.row_step = 16;
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 9, 0}), IsEmpty()) << "fits: nothing says otherwise";
  cloud.row_step = 2;
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}), ElementsAre(HasSubstr("20 bytes are taken")));
}

TEST(PointCloud2, DataOfAnotherLengthThanPromised) {
  Cloud2 cloud = TwoRows();
  cloud.data.resize(24);
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3}),
              ElementsAre(HasSubstr("width and height promise 4 points, the data hold 3")));
  cloud.row_step = 20;  // rows with gaps: only the first is whole
  EXPECT_THAT(RemarksOn(cloud, {1, 2}), ElementsAre(HasSubstr("the data hold 2")));
  cloud = TwoRows();
  cloud.height = 0;
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}),
              ElementsAre(HasSubstr("width and height promise 0 points, the data hold 4")));
  cloud = TwoRows();
  cloud.width = 4;
  cloud.height = 1;
  cloud.point_step = 4;  // of the first field
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}),
              ElementsAre(HasSubstr("a point_step of 4 bytes, which is too short for the fields; "
                                    "the data hold 8 bytes for each point")));
}

// Counts of points or bytes where the numbers of one point are meant.
TEST(PointCloud2, ACountThatReachesBeyondTheRecordIsNamed) {
  Cloud2 cloud = TwoRows();
  cloud.num_fields = 0;
  cloud.fields.clear();
  cloud.Add("x", 0, 7, /*count=*/4);
  cloud.Add("y", 4, 7, /*count=*/1);
  EXPECT_THAT(RemarksOn(cloud, {1, 2, 3, 4}),
              ElementsAre(HasSubstr("field 'x' has a count of 4, which reaches beyond the record "
                                    "of 8 bytes; 1 is taken")));
}

TEST(PointCloud2, ContradictionsAreErrors) {
  Cloud2 cloud = FourFloats();
  cloud.num_fields = 0;
  cloud.fields.clear();
  cloud.point_step = 0;
  EXPECT_THAT(ErrorOf(cloud.Ros1(), kRos1Cloud2), HasSubstr("point_step of 0"));
  // A point of one byte is 40 in memory: a message may not hold any number of them.
  cloud = Cloud2();
  cloud.Add("x", 0, 2);
  cloud.Add("y", 0, 2);
  cloud.point_step = 1;
  cloud.width = 5000000;
  cloud.data.assign(5000000, 'a');
  EXPECT_THAT(ErrorOf(cloud.Ros1(), kRos1Cloud2), HasSubstr("5000000 points, expected at most"));
  cloud = FourFloats();
  cloud.width = cloud.height = cloud.row_step = 0xFFFFFFFF;
  EXPECT_THAT(RemarksOn(cloud, {1}), ElementsAre(HasSubstr("the data hold 1")));
}

TEST(PointCloud2, AFieldBeyondTheRecordIsRefused) {
  Cloud2 cloud = FourFloats();
  cloud.Add("power", 13, 7);
  PointTable table;
  RadarScan scan;
  std::vector<std::string> remarks;
  std::string error;
  EXPECT_TRUE(ReadPointCloud(cloud.Ros1(), kRos1Cloud2, &table, &remarks, &error));
  EXPECT_FALSE(PointConverter(InputOptions()).Convert(table, &scan, &error));
  EXPECT_THAT(error, HasSubstr("'power'"));
}

// The start of a PointCloud with two points and two channels.
std::string NamedChannels(const std::string& header) {
  return header + LittleEndian<std::uint32_t>(2) + F32(1) + F32(2) + F32(3) + F32(4) + F32(5) +
         F32(6) + LittleEndian<std::uint32_t>(2);
}

TEST(PointCloud, ChannelsAreFoundByName) {
  const std::string ros1 =
      NamedChannels(LittleEndian<std::uint32_t>(0) + LittleEndian<std::uint32_t>(7) +
                    LittleEndian<std::uint32_t>(8) + Text("")) +
      Text("Power") + LittleEndian<std::uint32_t>(2) + F32(10) + F32(20) + Text("Doppler") +
      LittleEndian<std::uint32_t>(2) + F32(-1.5F) + F32(2.5F);
  const std::string cdr = NamedChannels(Bytes({0, 1, 0, 0}) + LittleEndian<std::uint32_t>(7) +
                                        LittleEndian<std::uint32_t>(8) +
                                        Text(std::string(1, '\0')) + Bytes({0, 0, 0})) +
                          Text(std::string("Power\0", 6)) + Bytes({0, 0}) +
                          LittleEndian<std::uint32_t>(2) + F32(10) + F32(20) +
                          Text(std::string("Doppler\0", 8)) + LittleEndian<std::uint32_t>(2) +
                          F32(-1.5F) + F32(2.5F);
  for (const auto& [payload, topic] : {std::pair(ros1, kRos1Cloud), std::pair(cdr, kCdrCloud)}) {
    const RadarScan scan = Read(payload, topic);
    ASSERT_EQ(scan.returns.size(), 2u);
    EXPECT_EQ(scan.returns[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(scan.returns[1].position, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(scan.returns[0].doppler, -1.5);
    EXPECT_EQ(scan.returns[1].doppler, 2.5);
    EXPECT_EQ(scan.returns[1].power, 20.0);
    std::int64_t stamp_ns = 0;
    EXPECT_TRUE(ReadPointCloudStamp(payload, topic, &stamp_ns));
    EXPECT_EQ(stamp_ns, 7000000008);
  }
}

TEST(PointCloud, AChannelOfAnotherLengthIsAnError) {
  const std::string payload =
      NamedChannels(LittleEndian<std::uint32_t>(0) + LittleEndian<std::uint32_t>(7) +
                    LittleEndian<std::uint32_t>(8) + Text("")) +
      Text("Doppler") + LittleEndian<std::uint32_t>(1) + F32(1) + Text("Power") +
      LittleEndian<std::uint32_t>(0);
  EXPECT_THAT(ErrorOf(payload, kRos1Cloud), HasSubstr("channel 'Doppler' has 1 values for 2"));
}

TEST(PointCloudMessages, CutAtAnyByteIsAnError) {
  RadarScan scan;
  scan.returns.resize(3);
  for (const MessageTopic& topic : {kRos1Cloud2, kCdrCloud2}) {
    const std::string payload = EncodePointCloud2(scan, topic.encoding, "radar");
    // The last byte says is_dense, which nobody looks at.
    for (std::size_t size = 0; size + 1 < payload.size(); ++size) {
      EXPECT_EQ(ErrorOf(payload.substr(0, size), topic), "the message is cut off") << size;
    }
    EXPECT_EQ(Read(payload.substr(0, payload.size() - 1), topic).returns.size(), 3u);
  }
  const std::string payload =
      NamedChannels(LittleEndian<std::uint32_t>(0) + LittleEndian<std::uint32_t>(7) +
                    LittleEndian<std::uint32_t>(8) + Text("")) +
      Text("Doppler") + LittleEndian<std::uint32_t>(2) + F32(1) + F32(2) + Text("Power") +
      LittleEndian<std::uint32_t>(2) + F32(3) + F32(4);
  for (std::size_t size = 0; size < payload.size(); ++size) {
    EXPECT_NE(ErrorOf(payload.substr(0, size), kRos1Cloud), "") << size;
  }
  EXPECT_EQ(Read(payload, kRos1Cloud).returns.size(), 2u);
}

TEST(PointCloudMessages, StampsBefore1970AreWrittenWithASign) {
  RadarScan scan;
  scan.stamp_ns = -1;
  std::int64_t stamp_ns = 0;
  EXPECT_TRUE(ReadPointCloudStamp(EncodePointCloud2(scan, "cdr", "radar"), kCdrCloud2, &stamp_ns));
  EXPECT_EQ(stamp_ns, -1);
}

}  // namespace
}  // namespace radive
