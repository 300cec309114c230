// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/ros1_bag_writer.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_record.h"
#include "radive/io/bytes/byte_order.h"

namespace radive {
namespace {

// So that the index can be entered later, the record is padded to this [bytes].
constexpr std::size_t kBagHeaderSize = 4096;

std::string TimeBytes(std::int64_t time_ns) {
  constexpr std::int64_t kPerSecond = 1000000000;
  return LittleEndian(static_cast<std::uint32_t>(time_ns / kPerSecond)) +
         LittleEndian(static_cast<std::uint32_t>(time_ns % kPerSecond));
}

std::string Ros1Sized(std::string_view bytes) {
  return LittleEndian(static_cast<std::uint32_t>(bytes.size())) + std::string(bytes);
}

std::string Field(const std::string& name, const std::string& value) {
  return Ros1Sized(name + "=" + value);
}

std::string OpField(Ros1Op op) { return Field("op", LittleEndian(static_cast<std::uint8_t>(op))); }

}  // namespace

std::unique_ptr<Ros1BagWriter> Ros1BagWriter::Create(const std::filesystem::path& path,
                                                     const Options& options,
                                                     std::string* error) {
  CHECK(options.compression != Compression::kZstd) << "ROS 1 bags know none, bz2 and lz4";
  std::unique_ptr<OutputStream> file = OutputStream::Create(path, error);
  if (file == nullptr) return nullptr;
  std::unique_ptr<Ros1BagWriter> writer(new Ros1BagWriter(std::move(file), options));
  writer->file_->Append(kRos1Magic);
  writer->file_->Append(writer->BagHeader(0));
  return writer;
}

std::string Ros1BagWriter::BagHeader(std::uint64_t index_position) const {
  const std::string header =
      OpField(Ros1Op::kBagHeader) + Field("index_pos", LittleEndian(index_position)) +
      Field("conn_count", LittleEndian(static_cast<std::uint32_t>(connections_.size()))) +
      Field("chunk_count", LittleEndian(static_cast<std::uint32_t>(chunks_.size())));
  return Ros1Sized(header) + Ros1Sized(std::string(kBagHeaderSize - header.size(), ' '));
}

int Ros1BagWriter::AddTopic(const MessageTopic& topic) {
  const auto connection = static_cast<std::uint32_t>(connections_.size());
  const bool is_cloud = topic.type == "sensor_msgs/PointCloud2";
  const std::string data =
      Field("topic", topic.name) + Field("type", topic.type) +
      Field("md5sum", is_cloud ? kPointCloud2Md5 : "*") +
      Field("message_definition", is_cloud ? PointCloud2Definition("ros1") : "");
  connections_.push_back(Ros1Sized(OpField(Ros1Op::kConnection) +
                                   Field("conn", LittleEndian(connection)) +
                                   Field("topic", topic.name)) +
                         Ros1Sized(data));
  is_connection_written_.push_back(false);
  return static_cast<int>(connection);
}

bool Ros1BagWriter::Write(int topic,
                          std::int64_t record_ns,
                          std::string_view payload,
                          std::string* error) {
  CHECK_GE(record_ns, 0);
  const auto connection = static_cast<std::size_t>(topic);
  if (!is_connection_written_.at(connection)) chunk_ += connections_[connection];
  is_connection_written_[connection] = true;
  index_[topic].push_back({record_ns, chunk_.size()});
  chunk_ += Ros1Sized(OpField(Ros1Op::kMessage) +
                      Field("conn", LittleEndian(static_cast<std::uint32_t>(topic))) +
                      Field("time", TimeBytes(record_ns)));
  chunk_ += LittleEndian(static_cast<std::uint32_t>(payload.size()));
  chunk_ += payload;
  if (chunk_.size() > options_.chunk_size) CloseChunk();
  return file_->Check(error);
}

void Ros1BagWriter::CloseChunk() {
  ChunkInfo info = {file_->size(), std::numeric_limits<std::int64_t>::max(), 0, {}};
  file_->Append(Ros1Sized(OpField(Ros1Op::kChunk) +
                          Field("compression", NameOf(options_.compression)) +
                          Field("size", LittleEndian(static_cast<std::uint32_t>(chunk_.size())))) +
                Ros1Sized(Compress(options_.compression, chunk_)));
  for (const auto& [connection, entries] : index_) {
    std::string data;
    for (const IndexEntry& entry : entries) {
      data += TimeBytes(entry.record_ns) + LittleEndian(static_cast<std::uint32_t>(entry.offset));
      info.start_ns = std::min(info.start_ns, entry.record_ns);
      info.end_ns = std::max(info.end_ns, entry.record_ns);
    }
    const auto count = static_cast<std::uint32_t>(entries.size());
    info.num_messages[connection] = count;
    file_->Append(Ros1Sized(OpField(Ros1Op::kIndex) + Field("ver", LittleEndian(std::uint32_t{1})) +
                            Field("conn", LittleEndian(static_cast<std::uint32_t>(connection))) +
                            Field("count", LittleEndian(count))) +
                  Ros1Sized(data));
  }
  chunks_.push_back(std::move(info));
  chunk_.clear();
  index_.clear();
}

bool Ros1BagWriter::Close(std::string* error) {
  if (!chunk_.empty()) CloseChunk();
  if (!options_.index) return file_->Close(error);
  const std::uint64_t index_position = file_->size();
  for (const std::string& connection : connections_) file_->Append(connection);
  for (const ChunkInfo& chunk : chunks_) {
    std::string data;
    for (const auto& [connection, count] : chunk.num_messages) {
      data += LittleEndian(static_cast<std::uint32_t>(connection)) + LittleEndian(count);
    }
    file_->Append(
        Ros1Sized(
            OpField(Ros1Op::kChunkInfo) + Field("ver", LittleEndian(std::uint32_t{1})) +
            Field("chunk_pos", LittleEndian(chunk.position)) +
            Field("start_time", TimeBytes(chunk.start_ns)) +
            Field("end_time", TimeBytes(chunk.end_ns)) +
            Field("count", LittleEndian(static_cast<std::uint32_t>(chunk.num_messages.size())))) +
        Ros1Sized(data));
  }
  file_->Overwrite(kRos1Magic.size(), BagHeader(index_position));
  return file_->Close(error);
}

}  // namespace radive
