// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/point_cloud_messages.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "radive/io/bags/ros_message_reader.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

// Far more than any scan has. A point can be a single byte of the message, but is 40 of a scan.
constexpr std::uint64_t kMostPoints = 1 << 22;

// PointField.datatype.
std::optional<NumericType> TypeOfNumber(std::uint8_t datatype) {
  switch (datatype) {
    case 1:
      return NumericType::kInt8;
    case 2:
      return NumericType::kUint8;
    case 3:
      return NumericType::kInt16;
    case 4:
      return NumericType::kUint16;
    case 5:
      return NumericType::kInt32;
    case 6:
      return NumericType::kUint32;
    case 7:
      return NumericType::kFloat32;
    case 8:
      return NumericType::kFloat64;
    default:
      return std::nullopt;
  }
}

RosMessageReader::Encoding EncodingOf(const MessageTopic& topic) {
  return topic.encoding == "ros1" ? RosMessageReader::Encoding::kRos1
                                  : RosMessageReader::Encoding::kCdr;
}

// Numbers of a PointCloud2, beside its fields.
struct Grid {
  std::uint64_t height = 0;
  std::uint64_t width = 0;
  std::uint64_t point_step = 0;  // [bytes]
  std::uint64_t row_step = 0;    // [bytes]
};

void ReadFields(RosMessageReader* reader, PointTable* table) {
  const std::uint32_t num_fields = reader->U32();
  for (std::uint32_t i = 0; i < num_fields && !reader->failed(); ++i) {
    PointField field;
    field.name = reader->String();
    field.offset = reader->U32();
    const std::optional<NumericType> type = TypeOfNumber(reader->U8());
    field.count = reader->U32();
    if (field.count == 0) field.count = 1;
    // A type of tomorrow makes its field unknown, not the others.
    if (type) {
      field.type = *type;
      table->fields.push_back(std::move(field));
    }
  }
}

std::string Bytes(std::uint64_t count) { return std::to_string(count) + " bytes"; }

// The bytes of a record from its start to the end of its last field, where each field has one
// number.
std::uint64_t EndOfFields(const PointTable& table) {
  std::uint64_t end = 0;
  for (const PointField& field : table.fields) {
    end = std::max<std::uint64_t>(end, field.offset + SizeOf(field.type));
  }
  return end;
}

// Drivers count points or bytes where the numbers of one point are meant. Only the first number of
// a field is used, so that a count that reaches beyond the record does no harm.
void RepairCounts(PointTable* table, std::vector<std::string>* remarks) {
  for (PointField& field : table->fields) {
    const std::size_t size = SizeOf(field.type);
    if (field.offset > table->stride || size > table->stride - field.offset) continue;
    if (field.count <= (table->stride - field.offset) / size) continue;
    remarks->push_back("field " + Quoted(field.name) + " has a count of " +
                       std::to_string(field.count) + ", which reaches beyond the record of " +
                       Bytes(table->stride) + "; 1 is taken");
    field.count = 1;
  }
}

// Whether rows that begin every `step` bytes are in the data.
bool RowsFit(const Grid& grid, std::uint64_t step, std::uint64_t data_size) {
  const std::uint64_t row = grid.width * grid.point_step;
  return step >= row && row <= data_size && (data_size - row) / step >= grid.height - 1;
}

// The distance of the rows [bytes]. row_step says it, but says nothing new, and many drivers set it
// wrongly: what fits the size of the data counts. Nothing when the data are too short for the rows.
std::optional<std::uint64_t> StepOfRows(const Grid& grid, std::uint64_t data_size) {
  const std::uint64_t row = grid.width * grid.point_step;
  const auto is_all = [&](std::uint64_t step) {
    return step >= row && data_size % step == 0 && data_size / step == grid.height;
  };
  if (is_all(grid.row_step)) return grid.row_step;
  if (is_all(row)) return row;
  if (RowsFit(grid, grid.row_step, data_size)) return grid.row_step;
  if (is_all(data_size / grid.height)) return data_size / grid.height;
  return RowsFit(grid, row, data_size) ? std::optional(row) : std::nullopt;
}

// Sets the records of the table: a view of `data`, unless there are gaps between the rows.
void SetRecords(const Grid& grid,
                std::uint64_t row_step,
                std::string_view data,
                PointTable* table) {
  table->num_points = static_cast<std::size_t>(grid.width * grid.height);
  table->data = data.data();
  const std::uint64_t row_size = grid.width * grid.point_step;
  if (grid.height <= 1 || row_size == row_step) return;
  for (std::uint64_t row = 0; row < grid.height; ++row) {
    const auto points =
        data.substr(static_cast<std::size_t>(row * row_step), static_cast<std::size_t>(row_size));
    table->owned.insert(table->owned.end(), points.begin(), points.end());
  }
  table->data = table->owned.data();
}

// Brings width, height, the two steps and the size of the data together, which contradict each
// other in the messages of many drivers.
bool ReadRecords(Grid grid,
                 std::string_view data,
                 PointTable* table,
                 std::vector<std::string>* remarks,
                 std::string* error) {
  const std::uint64_t size = data.size();
  const std::uint64_t num_promised = grid.width * grid.height;
  const std::uint64_t end_of_fields = EndOfFields(*table);
  if (grid.point_step < end_of_fields && num_promised > 0 && size % num_promised == 0 &&
      size / num_promised >= end_of_fields) {
    remarks->push_back("a point_step of " + Bytes(grid.point_step) +
                       ", which is too short for the fields; the data hold " +
                       Bytes(size / num_promised) + " for each point");
    grid.point_step = size / num_promised;
  }
  table->stride = static_cast<std::size_t>(grid.point_step);
  if (grid.point_step == 0) {
    if (num_promised == 0) return true;
    *error = "a point_step of 0";
    return false;
  }
  RepairCounts(table, remarks);
  if (num_promised > 0) {
    // Where there is one row its step says nothing at all.
    const std::optional<std::uint64_t> row_step =
        grid.height == 1 ? (RowsFit(grid, grid.width * grid.point_step, size)
                                ? std::optional(grid.width * grid.point_step)
                                : std::nullopt)
                         : StepOfRows(grid, size);
    if (row_step) {
      if (grid.height > 1 && grid.row_step != 0 && *row_step != grid.row_step) {
        remarks->push_back("a row_step of " + Bytes(grid.row_step) + " does not fit " +
                           Bytes(size) + " of data for " + std::to_string(grid.height) +
                           " rows of " + std::to_string(grid.width) + " points; " +
                           Bytes(*row_step) + " are taken");
      }
      SetRecords(grid, *row_step, data, table);
      return true;
    }
  }
  const std::uint64_t row = grid.width * grid.point_step;
  if (num_promised > 0 && grid.height > 1 && grid.row_step > row && size >= row) {
    grid.height = (size - row) / grid.row_step + 1;  // the rows that are whole
    SetRecords(grid, grid.row_step, data, table);
  } else {
    table->num_points = static_cast<std::size_t>(size / grid.point_step);
    table->data = data.data();
  }
  if (table->num_points == num_promised) return true;
  remarks->push_back("width and height promise " + std::to_string(num_promised) +
                     " points, the data hold " + std::to_string(table->num_points));
  return true;
}

bool ReadPointCloud2(RosMessageReader* reader,
                     PointTable* table,
                     std::vector<std::string>* remarks,
                     std::string* error) {
  Grid grid;
  grid.height = reader->U32();
  grid.width = reader->U32();
  ReadFields(reader, table);
  table->is_big_endian = reader->U8() != 0;
  grid.point_step = reader->U32();
  grid.row_step = reader->U32();
  const std::string_view data = reader->Bytes(reader->U32());
  if (reader->failed()) {
    *error = "the message is cut off";
    return false;
  }
  return ReadRecords(grid, data, table, remarks, error);
}

// The channels lie one behind the other: they are put side by side.
bool ReadNamedChannels(RosMessageReader* reader, PointTable* table, std::string* error) {
  constexpr std::size_t kFloat = 4;  // [bytes]
  const std::uint32_t num_points = reader->U32();
  const std::string_view points = reader->Bytes(3 * kFloat * num_points);
  for (const char* name : {"x", "y", "z"}) table->AddField(name, NumericType::kFloat32);
  const std::uint32_t num_channels = reader->U32();
  std::vector<std::string_view> channels;
  for (std::uint32_t i = 0; i < num_channels && !reader->failed(); ++i) {
    const std::string name(reader->String());
    const std::uint32_t num_values = reader->U32();
    channels.push_back(reader->Bytes(kFloat * num_values));
    if (!reader->failed() && num_values != num_points) {
      *error = "channel '" + name + "' has " + std::to_string(num_values) + " values for " +
               std::to_string(num_points) + " points";
      return false;
    }
    table->AddField(name, NumericType::kFloat32);
  }
  if (reader->failed()) {
    *error = "the message is cut off";
    return false;
  }
  table->is_big_endian = reader->is_big_endian();
  table->num_points = num_points;
  table->owned.resize(num_points * table->stride);
  table->data = table->owned.data();
  for (std::size_t i = 0; i < num_points; ++i) {
    char* place = table->owned.data() + i * table->stride;
    place += points.copy(place, 3 * kFloat, i * 3 * kFloat);
    for (const std::string_view channel : channels) {
      place += channel.copy(place, kFloat, i * kFloat);
    }
  }
  return true;
}

}  // namespace

PointCloudType PointCloudTypeOf(const MessageTopic& topic) {
  if (topic.type == "sensor_msgs/PointCloud2" || topic.type == "sensor_msgs/msg/PointCloud2") {
    return PointCloudType::kPointCloud2;
  }
  if (topic.type == "sensor_msgs/PointCloud" || topic.type == "sensor_msgs/msg/PointCloud") {
    return PointCloudType::kPointCloud;
  }
  return PointCloudType::kNone;
}

bool IsRosEncoding(const MessageTopic& topic) {
  return topic.encoding == "ros1" || topic.encoding == "cdr";
}

bool ReadPointCloudStamp(std::string_view payload,
                         const MessageTopic& topic,
                         std::int64_t* stamp_ns,
                         std::string_view* frame_id) {
  RosMessageReader reader(payload, EncodingOf(topic));
  const RosMessageReader::Header header = reader.ReadHeader();
  *stamp_ns = header.stamp_ns;
  if (frame_id != nullptr) *frame_id = header.frame_id;
  return !reader.failed();
}

bool ReadPointCloud(std::string_view payload,
                    const MessageTopic& topic,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error) {
  *table = PointTable();
  RosMessageReader reader(payload, EncodingOf(topic));
  reader.ReadHeader();
  const bool is_read = PointCloudTypeOf(topic) == PointCloudType::kPointCloud2
                           ? ReadPointCloud2(&reader, table, remarks, error)
                           : ReadNamedChannels(&reader, table, error);
  if (is_read && table->num_points <= kMostPoints) return true;
  if (is_read) {
    *error = std::to_string(table->num_points) + " points, expected at most " +
             std::to_string(kMostPoints);
  }
  *table = PointTable();
  return false;
}

}  // namespace radive
