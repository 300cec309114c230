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

// Writes MCAP files, messages in chunks.
class McapWriter : public MessageWriter {
 public:
  struct Options {
    Compression compression = Compression::kNone;  // of the chunks: kNone, kLz4 or kZstd
    bool index = true;                             // false: no index of messages, and no summary
    std::size_t chunk_size = 1 << 20;              // a chunk is closed when it is larger [bytes]
  };

  // Null, with the file and the reason in `error`, when it cannot be made.
  static std::unique_ptr<McapWriter> Create(const std::filesystem::path& path,
                                            const Options& options,
                                            std::string* error);

  // PointCloud2 comes with its definition; other types without a schema's text.
  int AddTopic(const MessageTopic& topic) override;
  bool Write(int topic,
             std::int64_t record_ns,
             std::string_view payload,
             std::string* error) override;
  bool Close(std::string* error) override;

 private:
  struct Channel {
    std::string records;  // schema and channel
    bool is_written = false;
    std::uint32_t num_messages = 0;
  };

  McapWriter(std::unique_ptr<OutputStream> file, const Options& options)
      : options_(options), file_(std::move(file)) {}

  void CloseChunk();
  std::string Statistics() const;

  const Options options_;
  const std::unique_ptr<OutputStream> file_;
  std::vector<Channel> channels_;
  std::string chunk_;                 // records of the chunk that is open
  std::map<int, std::string> index_;  // of that chunk, by channel
  std::int64_t chunk_start_ns_ = 0;
  std::int64_t chunk_end_ns_ = 0;
  std::int64_t start_ns_ = 0;  // of the file
  std::int64_t end_ns_ = 0;
  std::vector<std::string> chunk_index_;  // a record for each chunk
};

}  // namespace radive
