// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "radive/io/bags/chunked_bag_reader.h"
#include "radive/io/bags/ros1_record.h"

namespace radive {

// ROS 1 bag, version 2.0, chunks plain or packed with bz2 or lz4. With its index, or without it:
// of a recording that crashed or was cut off, all that is there is read, up to the break.
//
// Source: wiki.ros.org/Bags/Format/2.0.
class Ros1BagReader : public ChunkedBagReader {
 public:
  // Null, with the place and the expectation in `error`, when `file` is no such bag.
  static std::unique_ptr<Ros1BagReader> Open(std::unique_ptr<RandomAccessFile> file,
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
  using ChunkedBagReader::ChunkedBagReader;

  bool ReadIndexOfChunks(std::string* reason);
  bool ReadChunkInfo(const Ros1Record& info);
  bool ReadConnection(RandomAccessFile* content, const Ros1Record& record);
  void Scan();

  bool has_index_ = false;
};

}  // namespace radive
