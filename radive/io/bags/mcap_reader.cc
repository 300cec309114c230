// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/mcap_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "radive/io/bags/mcap_format.h"
#include "radive/io/bytes/byte_reader.h"
#include "radive/io/bytes/checksum.h"
#include "radive/io/bytes/random_access_file.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr std::uint64_t kRecordHead = 9;    // opcode and length [bytes]
constexpr std::uint64_t kMessageHead = 22;  // channel, sequence, two times [bytes]
constexpr std::uint64_t kFooter = kRecordHead + 20 + kMcapMagic.size();  // [bytes]
// Schemas are pages of text, not books [bytes].
constexpr std::uint64_t kLargestDefinition = 1 << 24;

constexpr std::uint8_t kOpFooter = 0x02;
constexpr std::uint8_t kOpSchema = 0x03;
constexpr std::uint8_t kOpChannel = 0x04;
constexpr std::uint8_t kOpMessage = 0x05;
constexpr std::uint8_t kOpChunk = 0x06;
constexpr std::uint8_t kOpMessageIndex = 0x07;
constexpr std::uint8_t kOpChunkIndex = 0x08;
constexpr std::uint8_t kOpStatistics = 0x0B;
constexpr std::uint8_t kOpDataEnd = 0x0F;

// Times are unsigned; none is beyond the year 2262.
std::int64_t Nanoseconds(std::uint64_t time) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(std::min(time, kLast));
}

}  // namespace

std::unique_ptr<McapReader> McapReader::Open(std::unique_ptr<RandomAccessFile> file,
                                             const MessageLimits& limits,
                                             std::string* error) {
  std::string buffer;
  const auto start =
      file->Read(0, std::min<std::uint64_t>(kMcapMagic.size(), file->size()), &buffer);
  if (!start || *start != kMcapMagic) {
    *error = file->name() + ": starts with " + Quoted(start.value_or(std::string_view())) +
             ", expected an MCAP file with byte 137 and 'MCAP0'";
    return nullptr;
  }
  std::unique_ptr<McapReader> reader(new McapReader(std::move(file), limits));
  std::string reason;
  reader->has_summary_ = reader->ReadSummary(&reason);
  if (!reader->has_summary_) {
    reader->Forget();
    reader->Scan();
    // Messages outside of chunks are in no index, which is no fault.
    if (reason.empty()) {
      reader->CheckCount();
    } else {
      reader->Warn("files without a summary", reason + ": read from the start to the end instead");
    }
  }
  if (!reader->unknown_compression_.empty() && !reader->has_known_chunk_) {
    *error = reader->file_name() + ": its chunks have the compression " +
             reader->unknown_compression_ + ", expected none, lz4 or zstd";
    return nullptr;
  }
  return reader;
}

std::string McapReader::Description() const {
  return "MCAP file " + file_name() +
         (has_summary_    ? ""
          : is_unchunked_ ? " (without chunks)"
                          : " (without summary)");
}

bool McapReader::ReadRecord(RandomAccessFile* content, std::uint64_t position, Record* record) {
  std::string buffer;
  const auto head = content->Read(position, kRecordHead, &buffer);
  if (!head) return false;
  ByteReader reader(*head);
  record->opcode = reader.U8();
  record->data_position = position + kRecordHead;
  record->data_size = reader.U64();
  // So that end() cannot overflow.
  return record->opcode != 0 && record->data_size < std::uint64_t{1} << 62;
}

// The footer says where the summary is: schemas, channels, and an index of the chunks.
bool McapReader::ReadSummary(std::string* reason) {
  std::string buffer;
  const std::uint64_t size = file()->size();
  const auto footer = size < kMcapMagic.size() + kFooter
                          ? std::nullopt
                          : file()->Read(size - kFooter, kFooter, &buffer);
  if (!footer || footer->substr(kFooter - kMcapMagic.size()) != kMcapMagic ||
      static_cast<std::uint8_t>(footer->front()) != kOpFooter) {
    *reason = "the file was not closed, or is cut off";
    return false;
  }
  ByteReader reader(footer->substr(kRecordHead));
  std::uint64_t position = reader.U64();
  if (position == 0) {
    *reason = "the file has no summary";
    return false;
  }
  reader.U64();  // where its offsets are
  if (const std::uint32_t crc = reader.U32(); crc != 0 && position < size - kFooter) {
    // Up to the checksum itself, at the end of the footer.
    constexpr std::uint64_t kBehind = 4 + kMcapMagic.size();
    FilePart checked(file(), position, size - kBehind - position);
    if (Crc32(&checked) != crc) {
      *reason = "the summary is not what its checksum says";
      return false;
    }
  }
  for (Record record; position < size - kFooter; position = record.end()) {
    const bool is_there = ReadRecord(file(), position, &record) && record.end() <= size - kFooter;
    const auto data =
        is_there ? file()->Read(record.data_position, record.data_size, &buffer) : std::nullopt;
    if (!data || !ReadSummaryRecord(record.opcode, *data)) {
      *reason = "the summary is damaged " + AtByte(position);
      return false;
    }
  }
  if (position != size - kFooter) {
    *reason = "the summary should be " + AtByte(position);
    return false;
  }
  is_unchunked_ = num_chunks_ == 0 && num_chunks_listed_ == 0 && num_messages_.value_or(0) > 0;
  if (is_unchunked_) return false;
  if (num_chunks_listed_ == 0 ? num_messages_ != 0u
                              : num_messages_ && num_chunks_ != num_chunks_listed_) {
    *reason = "the summary does not list the chunks";
    return false;
  }
  return true;
}

bool McapReader::ReadSummaryRecord(std::uint8_t opcode, std::string_view data) {
  if (opcode == kOpSchema || opcode == kOpChannel) return AddSchemaOrChannel(opcode, data);
  if (opcode == kOpChunkIndex) return AddChunkOfIndex(data);
  if (opcode != kOpStatistics) return true;
  ByteReader reader(data);
  num_messages_ = reader.U64();
  reader.Bytes(2 + 4 + 4 + 4);  // numbers of schemas, channels, attachments, metadata
  num_chunks_ = reader.U32();
  reader.Bytes(8 + 8);  // first and last time
  for (ByteReader counts(reader.String()); !counts.AtEnd() && !counts.failed();) {
    const std::uint16_t channel = counts.U16();
    CountMessages(channel, counts.U64());
  }
  return !reader.failed();
}

std::optional<Compression> McapReader::TakeCompression(std::string_view name) {
  const std::optional<Compression> compression = CompressionOfName(name);
  if (compression) {
    has_known_chunk_ = true;
  } else {
    unknown_compression_ = Quoted(name);
  }
  return compression;
}

// After a scan: whether all messages of the summary are there.
void McapReader::CheckCount() {
  std::uint64_t found = 0;
  for (const MessageTopic& topic : topics_) found += topic.num_messages.value_or(0);
  if (!num_messages_ || found == *num_messages_) return;
  Warn("files without all messages",
       "the summary counts " + std::to_string(*num_messages_) + " messages, the file holds " +
           std::to_string(found));
}

bool McapReader::AddChunkOfIndex(std::string_view data) {
  ByteReader reader(data);
  const std::int64_t start_ns = Nanoseconds(reader.U64());
  reader.U64();  // end
  const std::uint64_t position = reader.U64();
  reader.U64();  // length
  // All channels must be known here, for the user to choose from.
  for (ByteReader channels(reader.String()); !channels.AtEnd();) {
    const std::uint16_t channel = channels.U16();
    channels.U64();
    if (channels.failed() || !IsConnection(channel)) return false;
  }
  reader.U64();  // size of the message indexes
  TakeCompression(reader.String());
  if (reader.failed() || position >= file()->size()) return false;
  ++num_chunks_listed_;
  AddChunk({position, start_ns, 0});
  return true;
}

bool McapReader::AddSchemaOrChannel(std::uint8_t opcode, std::string_view data) {
  ByteReader reader(data);
  const std::uint16_t id = reader.U16();
  if (opcode == kOpSchema) {
    schema_names_[id] = reader.String();
    return !reader.failed();
  }
  const auto schema = schema_names_.find(reader.U16());
  MessageTopic topic;
  topic.name = reader.String();
  topic.encoding = reader.String();
  if (schema != schema_names_.end()) topic.type = schema->second;
  if (!reader.failed()) AddConnection(id, topic);
  return !reader.failed();
}

bool McapReader::ReadSchemaOrChannel(RandomAccessFile* content, const Record& record) {
  if (record.data_size > kLargestDefinition) return false;
  std::string buffer;
  const auto data = content->Read(record.data_position, record.data_size, &buffer);
  return data && AddSchemaOrChannel(record.opcode, *data);
}

std::optional<McapReader::MessageHead> McapReader::ReadMessageHead(RandomAccessFile* content,
                                                                   const Record& record) {
  std::string buffer;
  const auto head = content->Read(record.data_position, kMessageHead, &buffer);
  if (!head || record.data_size < kMessageHead) return std::nullopt;
  ByteReader reader(*head);
  const std::uint32_t channel = reader.U16();
  reader.U32();  // sequence
  return MessageHead{channel, Nanoseconds(reader.U64())};
}

// Finds the chunks by walking from record to record.
void McapReader::Scan() {
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  std::uint64_t position = kMcapMagic.size();
  ChunkPlace bare = {0, kNever, 0};  // the messages outside of chunks since the last other record
  const auto close_bare = [&] {
    if (bare.bare_size > 0) AddChunk(bare);
    bare = {0, kNever, 0};
  };
  bool is_complete = false;
  Record record;
  while (ReadRecord(file(), position, &record)) {
    std::uint64_t end = record.end() <= file()->size() ? record.end() : 0;
    if (record.opcode == kOpMessage && end != 0) {
      const auto head = ReadMessageHead(file(), record);
      if (!head) break;
      if (bare.bare_size == 0) bare.position = position;
      bare.bare_size = end - bare.position;
      bare.start_ns = std::min(bare.start_ns, head->log_ns);
      CountMessages(head->channel, 1);
    } else {
      close_bare();
      is_complete = record.opcode == kOpDataEnd || record.opcode == kOpFooter;
      if (is_complete) break;
      if (record.opcode == kOpChunk) end = AddScannedChunk(position);
      if (end != 0 && (record.opcode == kOpSchema || record.opcode == kOpChannel)) {
        if (!ReadSchemaOrChannel(file(), record)) break;
      }
    }
    if (end == 0) break;
    position = end;
  }
  close_bare();
  if (!is_complete) {
    Warn("broken files",
         "cut off or damaged " + AtByte(position) + " of " + std::to_string(file()->size()) +
             "; read up to there");
  }
}

bool McapReader::ReadChunkHeader(std::uint64_t position, ChunkHeader* header, std::string* reason) {
  *reason = "something else";
  Record record;
  if (!ReadRecord(file(), position, &record) || record.opcode != kOpChunk) return false;
  // Two times, the size, a checksum, and the length of the compression's name; then that name and
  // the stored size.
  constexpr std::uint64_t kHead = 8 + 8 + 8 + 4 + 4;
  constexpr std::uint32_t kLongestName = 64;
  std::string buffer;
  const auto head = file()->Read(record.data_position, kHead, &buffer);
  if (!head) return false;
  ByteReader reader(*head);
  reader.Bytes(16);
  header->size = reader.U64();
  const std::uint32_t crc = reader.U32();
  if (crc != 0) header->crc = crc;  // 0: there is none
  const std::uint32_t name_size = reader.U32();
  if (name_size > kLongestName) return false;
  const std::uint64_t name_position = record.data_position + kHead;
  const auto tail = file()->Read(name_position, name_size + std::uint64_t{8}, &buffer);
  if (!tail) return false;
  const std::string_view name = tail->substr(0, name_size);
  const auto compression = TakeCompression(name);
  if (!compression) {
    *reason = "a chunk with compression " + Quoted(name);
    return false;
  }
  const std::uint64_t stored_size = ByteReader(tail->substr(name_size)).U64();
  header->compression = *compression;
  header->data_position = name_position + name_size + 8;
  if (header->data_position > record.end() || stored_size > record.end() - header->data_position) {
    return false;
  }
  header->stored_size = std::min(stored_size, file()->size() - header->data_position);
  header->index_position = record.end() <= file()->size() ? record.end() : 0;
  return true;
}

bool McapReader::VisitIndex(const ChunkHeader& header, const MessageVisitor& visit) {
  if (header.index_position == 0) return false;
  std::uint64_t position = header.index_position;
  std::string buffer;
  bool has_index = false;
  for (Record record; ReadRecord(file(), position, &record); position = record.end()) {
    if (record.opcode != kOpMessageIndex) break;
    const auto data = file()->Read(record.data_position, record.data_size, &buffer);
    if (!data) return false;
    ByteReader reader(*data);
    const std::uint16_t channel = reader.U16();
    const std::string_view entries = reader.String();
    if (reader.failed() || entries.size() % 16 != 0) return false;
    has_index = true;
    for (ByteReader entry(entries); !entry.AtEnd();) {
      const std::int64_t log_ns = Nanoseconds(entry.U64());
      visit(channel, log_ns, entry.U64());
    }
  }
  return has_index;
}

std::uint64_t McapReader::VisitMessages(RandomAccessFile* content, const MessageVisitor& visit) {
  std::uint64_t position = 0;
  Record record;
  while (position < content->size() && ReadRecord(content, position, &record) &&
         record.end() <= content->size()) {
    if (record.opcode == kOpSchema || record.opcode == kOpChannel) {
      if (!ReadSchemaOrChannel(content, record)) break;
    } else if (record.opcode == kOpMessage) {
      const auto head = ReadMessageHead(content, record);
      if (!head) break;
      visit(head->channel, head->log_ns, position);
    }
    position = record.end();
  }
  return position;
}

ChunkedBagReader::Found McapReader::ReadMessage(RandomAccessFile* content,
                                                std::uint64_t offset,
                                                std::uint32_t* connection,
                                                std::string_view* payload,
                                                std::string* buffer) {
  *payload = {};
  Record record;
  if (!ReadRecord(content, offset, &record) || record.opcode != kOpMessage ||
      record.end() > content->size()) {
    return Found::kDamage;
  }
  const auto head = ReadMessageHead(content, record);
  if (!head) return Found::kDamage;
  const std::uint64_t size = record.data_size - kMessageHead;
  if (size > limits().message) return Found::kTooLarge;
  const auto data = content->Read(record.data_position + kMessageHead, size, buffer);
  if (!data) return Found::kDamage;
  *connection = head->channel;
  *payload = *data;
  return Found::kMessage;
}

}  // namespace radive
