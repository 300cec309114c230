// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/mcap_writer.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>

#include "radive/io/bags/mcap_format.h"
#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/checksum.h"

namespace radive {
namespace {

std::string U16(std::size_t value) { return LittleEndian(static_cast<std::uint16_t>(value)); }
std::string U32(std::size_t value) { return LittleEndian(static_cast<std::uint32_t>(value)); }
std::string U64(std::uint64_t value) { return LittleEndian(value); }
std::string Time(std::int64_t time_ns) { return U64(static_cast<std::uint64_t>(time_ns)); }
std::string McapSized(const std::string& bytes) { return U32(bytes.size()) + bytes; }

std::string Record(std::uint8_t opcode, const std::string& data) {
  return static_cast<char>(opcode) + U64(data.size()) + data;
}

}  // namespace

std::unique_ptr<McapWriter> McapWriter::Create(const std::filesystem::path& path,
                                               const Options& options,
                                               std::string* error) {
  CHECK(options.compression != Compression::kBz2) << "MCAP knows none, lz4 and zstd";
  std::unique_ptr<OutputStream> file = OutputStream::Create(path, error);
  if (file == nullptr) return nullptr;
  std::unique_ptr<McapWriter> writer(new McapWriter(std::move(file), options));
  writer->file_->Append(kMcapMagic);
  writer->file_->Append(Record(0x01, McapSized("ros2") + McapSized("radive")));  // header
  return writer;
}

int McapWriter::AddTopic(const MessageTopic& topic) {
  const std::size_t id = channels_.size();
  const bool is_ros1 = topic.encoding == "ros1";
  const bool is_cloud =
      topic.type == "sensor_msgs/PointCloud2" || topic.type == "sensor_msgs/msg/PointCloud2";
  const std::string definition = is_cloud ? PointCloud2Definition(topic.encoding) : "";
  // Schemas count from 1: 0 means that there is none.
  const std::string schema = U16(id + 1) + McapSized(topic.type) +
                             McapSized(is_ros1 ? "ros1msg" : "ros2msg") + McapSized(definition);
  const std::string channel =
      U16(id) + U16(id + 1) + McapSized(topic.name) + McapSized(topic.encoding) + McapSized("");
  channels_.push_back({Record(0x03, schema) + Record(0x04, channel), false, 0});
  return static_cast<int>(id);
}

bool McapWriter::Write(int topic,
                       std::int64_t record_ns,
                       std::string_view payload,
                       std::string* error) {
  CHECK_GE(record_ns, 0);
  Channel& channel = channels_.at(static_cast<std::size_t>(topic));
  if (!channel.is_written) chunk_ += channel.records;
  channel.is_written = true;
  if (index_.empty()) chunk_start_ns_ = chunk_end_ns_ = record_ns;
  if (index_.empty() && chunk_index_.empty()) start_ns_ = end_ns_ = record_ns;
  chunk_start_ns_ = std::min(chunk_start_ns_, record_ns);
  chunk_end_ns_ = std::max(chunk_end_ns_, record_ns);
  index_[topic] += Time(record_ns) + U64(chunk_.size());
  const std::string head = U16(static_cast<std::size_t>(topic)) + U32(channel.num_messages) +
                           Time(record_ns) + Time(record_ns);
  ++channel.num_messages;
  chunk_ += static_cast<char>(0x05) + U64(head.size() + payload.size()) + head;
  chunk_ += payload;
  if (chunk_.size() > options_.chunk_size) CloseChunk();
  return file_->Check(error);
}

void McapWriter::CloseChunk() {
  const std::uint64_t position = file_->size();
  const std::string packed = Compress(options_.compression, chunk_);
  const std::string name =
      options_.compression == Compression::kNone ? "" : NameOf(options_.compression);
  file_->Append(Record(0x06,
                       Time(chunk_start_ns_) + Time(chunk_end_ns_) + U64(chunk_.size()) +
                           U32(Crc32(chunk_)) + McapSized(name) + U64(packed.size()) + packed));
  const std::uint64_t index_position = file_->size();
  std::string places;
  for (const auto& [channel, entries] : index_) {
    if (!options_.index) continue;
    places += U16(static_cast<std::size_t>(channel)) + U64(file_->size());
    file_->Append(Record(0x07, U16(static_cast<std::size_t>(channel)) + McapSized(entries)));
  }
  chunk_index_.push_back(Record(0x08,
                                Time(chunk_start_ns_) + Time(chunk_end_ns_) + U64(position) +
                                    U64(index_position - position) + McapSized(places) +
                                    U64(file_->size() - index_position) + McapSized(name) +
                                    U64(packed.size()) + U64(chunk_.size())));
  start_ns_ = std::min(start_ns_, chunk_start_ns_);
  end_ns_ = std::max(end_ns_, chunk_end_ns_);
  chunk_.clear();
  index_.clear();
}

std::string McapWriter::Statistics() const {
  std::uint64_t num_messages = 0;
  std::string counts;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    num_messages += channels_[i].num_messages;
    counts += U16(i) + U64(channels_[i].num_messages);
  }
  return Record(0x0B,
                U64(num_messages) + U16(channels_.size()) + U32(channels_.size()) + U32(0) +
                    U32(0) + U32(chunk_index_.size()) + Time(start_ns_) + Time(end_ns_) +
                    McapSized(counts));
}

bool McapWriter::Close(std::string* error) {
  if (!index_.empty()) CloseChunk();
  file_->Append(Record(0x0F, U32(0)));  // end of the data, without a checksum
  // A checksum of 0 means that there is none.
  const std::uint64_t position = options_.index ? file_->size() : 0;
  std::string summary;
  if (options_.index) {
    for (const Channel& channel : channels_) summary += channel.records;
    for (const std::string& chunk : chunk_index_) summary += chunk;
    summary += Statistics();
    file_->Append(summary);
  }
  std::string footer = Record(0x02, U64(position) + U64(0) + U32(0));
  footer.resize(footer.size() - 4);
  file_->Append(footer + U32(options_.index ? Crc32(summary + footer) : 0));
  file_->Append(kMcapMagic);
  return file_->Close(error);
}

}  // namespace radive
