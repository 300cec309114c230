// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "radive/io/bags/chunked_bag_reader.h"

namespace radive {

// MCAP file, chunks plain or packed with lz4 or zstd, or no chunks at all. With its summary, or
// without it: of a file that was cut off, all that is there is read, up to the break. Checksums of
// the chunks and of the summary are looked at, that of the data as a whole is not: it would take
// reading the whole file.
//
// Source: mcap.dev/spec.
class McapReader : public ChunkedBagReader {
 public:
  // Null, with the place and the expectation in `error`, when `file` is no MCAP file.
  static std::unique_ptr<McapReader> Open(std::unique_ptr<RandomAccessFile> file,
                                          const MessageLimits& limits,
                                          std::string* error);

  std::string Description() const override;

 protected:
  bool ReadChunkHeader(std::uint64_t position, ChunkHeader* header, std::string* reason) override;
  bool VisitIndex(const ChunkHeader& header, const MessageVisitor& visit) override;
  std::uint64_t VisitMessages(RandomAccessFile* content, const MessageVisitor& visit) override;
  Found ReadMessage(RandomAccessFile* content,
                    std::uint64_t offset,
                    std::uint32_t* connection,
                    std::string_view* payload,
                    std::string* buffer) override;

 private:
  // "u8 opcode, u64 length, data".
  struct Record {
    std::uint8_t opcode = 0;
    std::uint64_t data_position = 0;
    std::uint64_t data_size = 0;
    std::uint64_t end() const { return data_position + data_size; }
  };
  struct MessageHead {
    std::uint32_t channel = 0;
    std::int64_t log_ns = 0;
  };

  using ChunkedBagReader::ChunkedBagReader;

  static bool ReadRecord(RandomAccessFile* content, std::uint64_t position, Record* record);
  static std::optional<MessageHead> ReadMessageHead(RandomAccessFile* content,
                                                    const Record& record);
  bool ReadSummary(std::string* reason);
  bool ReadSummaryRecord(std::uint8_t opcode, std::string_view data);
  bool ReadSchemaOrChannel(RandomAccessFile* content, const Record& record);
  bool AddSchemaOrChannel(std::uint8_t opcode, std::string_view data);
  bool AddChunkOfIndex(std::string_view data);
  // The compression of a chunk by its name; notes which are known and which are not.
  std::optional<Compression> TakeCompression(std::string_view name);
  void CheckCount();
  void Scan();

  bool has_summary_ = false;
  std::unordered_map<std::uint16_t, std::string> schema_names_;
  std::optional<std::uint64_t> num_messages_;  // of the file, as its summary says
  std::uint32_t num_chunks_ = 0;               // as the summary says
  std::uint32_t num_chunks_listed_ = 0;
  bool is_unchunked_ = false;  // as the summary says: all messages are outside of chunks
  bool has_known_chunk_ = false;
  std::string unknown_compression_;  // of a chunk
};

}  // namespace radive
