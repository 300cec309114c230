// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "radive/io/bags/message_source.h"
#include "radive/io/bytes/compression.h"
#include "radive/io/bytes/random_access_file.h"

namespace radive {

// What ROS 1 bags and MCAP files have in common: messages of connections (MCAP: channels) lie in
// chunks, which may be compressed and may overlap in time. Behind a chunk there may be an index of
// its messages.
//
// Plays the messages of all chunks in time order, or in that of the file where the clock of the
// recorder was set back (RecordClock). A chunk is opened when its time has come; those
// without wanted messages are not read beyond their index, and out of chunks without compression
// only the wanted messages are read. Few chunks are in memory at a time (kCacheBytes).
//
// Damage is passed over with a warning: a message, the rest of a chunk. A chunk whose checksum is
// wrong is read all the same, with a warning; that of a chunk without compression is looked at
// where at least half of its bytes are wanted, for it takes all of them. Bytes that the disk does
// not give (RandomAccessFile::read_error) are no damage but an error.
class ChunkedBagReader : public MessageSource {
 public:
  void Select(const std::vector<int>& topics) final;
  Status Next(Message* message) final;
  std::int64_t start_ns() const final;

  // The file and why bytes of it could not be read; empty: all could be.
  std::string read_error() const {
    return file_->read_error().empty() ? "" : file_->name() + ": " + file_->read_error();
  }

 protected:
  // Where a chunk is, known without reading it.
  struct ChunkPlace {
    std::uint64_t position = 0;   // of the chunk's record; of the first message of a bare chunk
    std::int64_t start_ns = 0;    // none of its messages is earlier
    std::uint64_t bare_size = 0;  // > 0: no chunk, but messages outside of any, this many bytes
  };

  // What the record of a chunk says.
  struct ChunkHeader {
    Compression compression = Compression::kNone;
    std::uint64_t data_position = 0;
    std::uint64_t stored_size = 0;     // [bytes], what of it is in the file
    std::uint64_t size = 0;            // without compression [bytes]
    std::uint64_t index_position = 0;  // behind the chunk; 0: the file ends in the chunk
    std::optional<std::uint32_t> crc;  // CRC-32 of what it unpacks to, where the file has it
  };

  // Takes a connection, a time, and the place of a message from the start of its chunk.
  using MessageVisitor =
      std::function<void(std::uint32_t connection, std::int64_t record_ns, std::uint64_t offset)>;

  enum class Found { kMessage, kDamage, kTooLarge };

  ChunkedBagReader(std::unique_ptr<RandomAccessFile> file, const MessageLimits& limits)
      : file_(std::move(file)), limits_(limits) {}

  // False when there is no chunk at `position`; what there is instead is then in `reason`.
  virtual bool ReadChunkHeader(std::uint64_t position,
                               ChunkHeader* header,
                               std::string* reason) = 0;

  // Visits the messages that the index behind the chunk lists. False when there is no index, or a
  // damaged one.
  virtual bool VisitIndex(const ChunkHeader& header, const MessageVisitor& visit) = 0;

  // Visits the messages in the bytes of a chunk, and takes up the connections that it meets there.
  // Returns where it stopped: the size of `content` when nothing is damaged or cut.
  virtual std::uint64_t VisitMessages(RandomAccessFile* content, const MessageVisitor& visit) = 0;

  // Reads the message at `offset` of a chunk; the payload may be in `buffer`.
  virtual Found ReadMessage(RandomAccessFile* content,
                            std::uint64_t offset,
                            std::uint32_t* connection,
                            std::string_view* payload,
                            std::string* buffer) = 0;

  // Makes a connection known. Several connections may be of one topic.
  void AddConnection(std::uint32_t connection, const MessageTopic& topic);
  bool IsConnection(std::uint32_t connection) const { return topic_of_.count(connection) > 0; }
  // Adds to the number of messages of a connection that is known.
  void CountMessages(std::uint32_t connection, std::uint64_t count);

  // Makes a chunk known. To be called for all of them before the first Select().
  void AddChunk(const ChunkPlace& place) { chunks_.push_back(place); }

  // Reads the chunk there, for a file without an index of its chunks: its connections, the number
  // of its messages and their start. Decompresses it only when its own index is missing or names
  // unknown connections. Returns where the record behind it is; 0: the file ends in it.
  std::uint64_t AddScannedChunk(std::uint64_t position);

  void Forget();  // connections, topics and chunks

  RandomAccessFile* file() { return file_.get(); }
  const std::string& file_name() const { return file_->name(); }
  const MessageLimits& limits() const { return limits_; }
  void Warn(const std::string& kind, const std::string& text) {
    warnings_.Add(kind + " in " + file_->name(), file_->name() + ": " + text);
  }

 private:
  struct Entry {
    std::int64_t record_ns;
    std::int64_t order_ns;  // 0 in the order of the file
    std::size_t chunk;
    std::uint64_t offset;
    bool operator>(const Entry& other) const;
  };

  // The bytes of an open chunk.
  struct Content {
    std::size_t chunk = 0;
    std::string unpacked;  // empty without compression
    std::unique_ptr<RandomAccessFile> bytes;
  };

  static constexpr std::size_t kCacheBytes = std::size_t{64} << 20;

  bool HeaderOf(std::size_t chunk, ChunkHeader* header);
  Content* Open(std::size_t chunk);
  std::unique_ptr<Content> Unpack(std::size_t chunk, const ChunkHeader& header);
  void MakeRoom();
  void Queue(std::size_t chunk);
  // Of the recorder; false where the starts of the chunks do not suggest it.
  bool WasClockSetBack();
  void TakeFileOrder();
  // Warns when the bytes of a chunk, all of them, are not what the checksum says; once for each.
  void CheckCrc(std::size_t chunk, const ChunkHeader& header, RandomAccessFile* bytes);
  bool SpendUnpacking(std::uint64_t size);
  Status NextOfQueue(Message* message);

  const std::unique_ptr<RandomAccessFile> file_;
  const MessageLimits limits_;
  std::unordered_map<std::uint32_t, int> topic_of_;  // by connection
  std::vector<bool> is_wanted_;                      // by topic
  std::vector<ChunkPlace> chunks_;                   // in time order from Select() on
  std::size_t next_chunk_ = 0;                       // that is not in the queue
  bool is_in_file_order_ = false;                    // instead of that of the times
  std::vector<Entry> queue_;                         // heap of the messages of the opened chunks
  std::list<std::unique_ptr<Content>> cache_;        // the one used last is in front
  std::unordered_map<std::size_t, std::uint64_t> bytes_given_;  // of payload, by chunk
  std::unordered_set<std::uint64_t> checked_;                   // chunks, by position
  std::uint64_t unpacked_bytes_ = 0;
  std::string buffer_;
};

}  // namespace radive
