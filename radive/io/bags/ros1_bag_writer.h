// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bags/message_writer.h"
#include "radive/io/bytes/compression.h"
#include "radive/io/bytes/output_stream.h"

namespace radive {

// Writes ROS 1 bags, version 2.0.
class Ros1BagWriter : public MessageWriter {
 public:
  struct Options {
    Compression compression = Compression::kNone;  // of the chunks: kNone, kBz2 or kLz4
    bool index = true;  // false: as a recorder that crashed leaves the bag, index_pos 0
    std::size_t chunk_size = 768 << 10;  // a chunk is closed when it is larger [bytes]
  };

  // Null, with the file and the reason in `error`, when it cannot be made.
  static std::unique_ptr<Ros1BagWriter> Create(const std::filesystem::path& path,
                                               const Options& options,
                                               std::string* error);

  // PointCloud2 comes with its definition; other types with an empty one, as if unknown.
  int AddTopic(const MessageTopic& topic) override;
  bool Write(int topic,
             std::int64_t record_ns,
             std::string_view payload,
             std::string* error) override;
  bool Close(std::string* error) override;

 private:
  struct IndexEntry {
    std::int64_t record_ns;
    std::size_t offset;  // in the chunk
  };
  struct ChunkInfo {
    std::uint64_t position;
    std::int64_t start_ns;
    std::int64_t end_ns;
    std::map<int, std::uint32_t> num_messages;  // by connection
  };

  Ros1BagWriter(std::unique_ptr<OutputStream> file, const Options& options)
      : options_(options), file_(std::move(file)) {}

  std::string BagHeader(std::uint64_t index_position) const;
  void CloseChunk();

  const Options options_;
  const std::unique_ptr<OutputStream> file_;
  std::vector<std::string> connections_;          // their records
  std::vector<bool> is_connection_written_;       // into some chunk
  std::string chunk_;                             // records of the chunk that is open
  std::map<int, std::vector<IndexEntry>> index_;  // of that chunk, by connection
  std::vector<ChunkInfo> chunks_;
};

}  // namespace radive
