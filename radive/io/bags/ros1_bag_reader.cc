// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/ros1_bag_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "radive/io/bytes/byte_reader.h"
#include "radive/io/bytes/random_access_file.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

// Definitions of message types are pages of text, not books [bytes].
constexpr std::uint64_t kLargestConnection = 1 << 24;

}  // namespace

std::unique_ptr<Ros1BagReader> Ros1BagReader::Open(std::unique_ptr<RandomAccessFile> file,
                                                   const MessageLimits& limits,
                                                   std::string* error) {
  std::string buffer;
  const auto start =
      file->Read(0, std::min<std::uint64_t>(kRos1Magic.size(), file->size()), &buffer);
  if (!start || *start != kRos1Magic) {
    *error = file->name() + ": starts with " +
             Quoted(start.value_or(std::string_view()).substr(0, kRos1Magic.size() - 1)) +
             ", expected a ROS 1 bag with '#ROSBAG V2.0'";
    return nullptr;
  }
  Ros1Record header;
  if (ReadRos1Record(file.get(), kRos1Magic.size(), &header)) {
    const std::string encryptor(Ros1Field(header.header, "encryptor").value_or(""));
    if (!encryptor.empty()) {
      *error = file->name() + ": is encrypted (" + Quoted(encryptor) +
               "), expected a plain bag; see 'rosbag decrypt'";
      return nullptr;
    }
  }
  std::unique_ptr<Ros1BagReader> reader(new Ros1BagReader(std::move(file), limits));
  std::string reason;
  reader->has_index_ = reader->ReadIndexOfChunks(&reason);
  if (!reader->has_index_) {
    reader->Forget();
    reader->Warn("bags without an index", reason + ": read from the start to the end instead");
    reader->Scan();
  }
  return reader;
}

std::string Ros1BagReader::Description() const {
  return "ROS 1 bag " + file_name() + (has_index_ ? "" : " (without index)");
}

// The bag header says where the connections and the places of the chunks are: at the end.
bool Ros1BagReader::ReadIndexOfChunks(std::string* reason) {
  Ros1Record header;
  if (!ReadRos1Record(file(), kRos1Magic.size(), &header) || header.op() != Ros1Op::kBagHeader) {
    *reason = "no bag header " + AtByte(kRos1Magic.size());
    return false;
  }
  const std::uint64_t index = header.Unsigned("index_pos", 8).value_or(0);
  if (index == 0) {
    *reason = "the bag was not closed";
    return false;
  }
  if (index < header.end() || index > file()->size()) {
    *reason = "the index should be " + AtByte(index) + " but the file has " +
              std::to_string(file()->size()) + " bytes";
    return false;
  }
  std::uint64_t num_connections = 0;
  std::uint64_t num_chunks = 0;
  std::uint64_t position = index;
  for (Ros1Record record; position < file()->size(); position = record.end()) {
    const bool is_there =
        ReadRos1Record(file(), position, &record) && record.end() <= file()->size();
    const bool is_connection = is_there && record.op() == Ros1Op::kConnection;
    const bool is_chunk = is_there && record.op() == Ros1Op::kChunkInfo;
    if (!(is_connection && ReadConnection(file(), record)) &&
        !(is_chunk && ReadChunkInfo(record))) {
      *reason = "the index is damaged " + AtByte(position);
      return false;
    }
    num_connections += is_connection ? 1 : 0;
    num_chunks += is_chunk ? 1 : 0;
  }
  if (num_connections != header.Unsigned("conn_count", 4).value_or(num_connections) ||
      num_chunks != header.Unsigned("chunk_count", 4).value_or(num_chunks)) {
    *reason = "the index is cut off " + AtByte(position);
    return false;
  }
  return true;
}

bool Ros1BagReader::ReadChunkInfo(const Ros1Record& info) {
  const auto position = info.Unsigned("chunk_pos", 8);
  const auto start_ns = info.Time("start_time");
  std::string buffer;
  const auto counts = file()->Read(info.data_position, info.data_size, &buffer);
  if (!position || *position >= file()->size() || !start_ns || !counts) return false;
  AddChunk({*position, *start_ns, 0});
  for (ByteReader reader(*counts); !reader.AtEnd();) {
    const std::uint32_t connection = reader.U32();
    const std::uint32_t count = reader.U32();
    if (reader.failed() || !IsConnection(connection)) return false;
    CountMessages(connection, count);
  }
  return true;
}

bool Ros1BagReader::ReadConnection(RandomAccessFile* content, const Ros1Record& record) {
  const auto connection = record.Unsigned("conn", 4);
  const auto topic = Ros1Field(record.header, "topic");
  if (!connection || !topic || record.data_size > kLargestConnection) return false;
  std::string buffer;
  const auto data = content->Read(record.data_position, record.data_size, &buffer);
  if (!data) return false;
  const auto type = Ros1Field(*data, "type");
  if (!type) return false;
  AddConnection(static_cast<std::uint32_t>(*connection),
                {std::string(*topic), std::string(*type), "ros1", 0});
  return true;
}

// Finds the chunks by walking from record to record.
void Ros1BagReader::Scan() {
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  std::uint64_t position = kRos1Magic.size();
  ChunkPlace bare = {0, kNever, 0};  // the messages outside of chunks since the last other record
  const auto close_bare = [&] {
    if (bare.bare_size > 0) AddChunk(bare);
    bare = {0, kNever, 0};
  };
  Ros1Record record;
  while (position < file()->size() && ReadRos1Record(file(), position, &record)) {
    std::uint64_t end = record.end() <= file()->size() ? record.end() : 0;
    const Ros1Op op = record.op();
    if (op == Ros1Op::kMessage && end != 0) {
      if (bare.bare_size == 0) bare.position = position;
      bare.bare_size = end - bare.position;
      bare.start_ns = std::min(bare.start_ns, record.Time("time").value_or(kNever));
      CountMessages(static_cast<std::uint32_t>(record.Unsigned("conn", 4).value_or(0)), 1);
    } else {
      close_bare();
      if (op == Ros1Op::kChunk) end = AddScannedChunk(position);
      if (op == Ros1Op::kConnection && end != 0) ReadConnection(file(), record);
      if (op < Ros1Op::kMessage || op > Ros1Op::kConnection) end = 0;
    }
    if (end == 0) break;
    position = end;
  }
  close_bare();
  if (position < file()->size()) {
    Warn("broken bags",
         "cut off or damaged " + AtByte(position) + " of " + std::to_string(file()->size()) +
             "; read up to there");
  }
}

bool Ros1BagReader::ReadChunkHeader(std::uint64_t position,
                                    ChunkHeader* header,
                                    std::string* reason) {
  Ros1Record record;
  if (!ReadRos1Record(file(), position, &record) || record.op() != Ros1Op::kChunk) {
    *reason = "something else";
    return false;
  }
  const std::string_view name = Ros1Field(record.header, "compression").value_or("");
  const auto compression = CompressionOfName(name);
  const auto size = record.Unsigned("size", 4);
  if (!compression || !size) {
    *reason = "a chunk with compression " + Quoted(name);
    return false;
  }
  header->compression = *compression;
  header->data_position = record.data_position;
  header->stored_size = std::min(record.data_size, file()->size() - record.data_position);
  header->size = *size;
  header->index_position = record.end() <= file()->size() ? record.end() : 0;
  return true;
}

bool Ros1BagReader::VisitIndex(const ChunkHeader& header, const MessageVisitor& visit) {
  if (header.index_position == 0) return false;
  std::uint64_t position = header.index_position;
  std::string buffer;
  bool has_index = false;
  for (Ros1Record record; ReadRos1Record(file(), position, &record); position = record.end()) {
    if (record.op() != Ros1Op::kIndex) break;
    const auto connection = record.Unsigned("conn", 4);
    const auto data = file()->Read(record.data_position, record.data_size, &buffer);
    if (record.Unsigned("ver", 4) != 1u || !connection || !data || data->size() % 12 != 0) {
      return false;
    }
    has_index = true;
    for (ByteReader reader(*data); !reader.AtEnd();) {
      const std::int64_t record_ns = Ros1Time(reader.U64());
      visit(static_cast<std::uint32_t>(*connection), record_ns, reader.U32());
    }
  }
  return has_index;
}

std::uint64_t Ros1BagReader::VisitMessages(RandomAccessFile* content, const MessageVisitor& visit) {
  std::uint64_t position = 0;
  Ros1Record record;
  while (position < content->size() && ReadRos1Record(content, position, &record) &&
         record.end() <= content->size()) {
    if (record.op() == Ros1Op::kConnection) {
      if (!ReadConnection(content, record)) break;
    } else if (record.op() == Ros1Op::kMessage) {
      const auto connection = record.Unsigned("conn", 4);
      const auto record_ns = record.Time("time");
      if (!connection || !record_ns) break;
      visit(static_cast<std::uint32_t>(*connection), *record_ns, position);
    } else {
      break;
    }
    position = record.end();
  }
  return position;
}

ChunkedBagReader::Found Ros1BagReader::ReadMessage(RandomAccessFile* content,
                                                   std::uint64_t offset,
                                                   std::uint32_t* connection,
                                                   std::string_view* payload,
                                                   std::string* buffer) {
  *payload = {};
  Ros1Record record;
  if (!ReadRos1Record(content, offset, &record) || record.op() != Ros1Op::kMessage) {
    return Found::kDamage;
  }
  const auto found = record.Unsigned("conn", 4);
  if (!found || record.end() > content->size()) return Found::kDamage;
  if (record.data_size > limits().message) return Found::kTooLarge;
  const auto data = content->Read(record.data_position, record.data_size, buffer);
  if (!data) return Found::kDamage;
  *connection = static_cast<std::uint32_t>(*found);
  *payload = *data;
  return Found::kMessage;
}

}  // namespace radive
