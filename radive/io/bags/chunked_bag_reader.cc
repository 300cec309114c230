// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/chunked_bag_reader.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "radive/io/bags/record_clock.h"
#include "radive/io/bytes/checksum.h"
#include "radive/io/bytes/random_access_file.h"

namespace radive {
namespace {

// Whether the wanted ones of the messages at these offsets are at least half of the bytes of a
// chunk: each reaches up to the next.
bool MostIsWanted(std::vector<std::pair<std::uint64_t, bool>> places, std::uint64_t size) {
  std::sort(places.begin(), places.end());
  std::uint64_t wanted = 0;
  for (std::size_t i = 0; i < places.size() && places[i].first < size; ++i) {
    const std::uint64_t end = i + 1 < places.size() ? std::min(places[i + 1].first, size) : size;
    if (places[i].second) wanted += end - places[i].first;
  }
  return wanted >= size / 2;
}

// When a message was recorded, and where it lies in its chunk.
struct StoredTime {
  std::uint64_t offset;
  int topic;
  std::int64_t record_ns;
};

void AddInFileOrder(std::vector<StoredTime> messages, RecordClock* clock) {
  std::sort(messages.begin(), messages.end(), [](const StoredTime& a, const StoredTime& b) {
    return a.offset < b.offset;
  });
  for (const StoredTime& message : messages) {
    clock->Add(static_cast<std::uint64_t>(message.topic), message.record_ns);
  }
}

}  // namespace

bool ChunkedBagReader::Entry::operator>(const Entry& other) const {
  return std::tie(order_ns, chunk, offset) > std::tie(other.order_ns, other.chunk, other.offset);
}

void ChunkedBagReader::AddConnection(std::uint32_t connection, const MessageTopic& topic) {
  if (IsConnection(connection)) return;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const MessageTopic& known = topics_[i];
    if (known.name == topic.name && known.type == topic.type && known.encoding == topic.encoding) {
      topic_of_[connection] = static_cast<int>(i);
      return;
    }
  }
  topic_of_[connection] = static_cast<int>(topics_.size());
  topics_.push_back(topic);
}

void ChunkedBagReader::CountMessages(std::uint32_t connection, std::uint64_t count) {
  const auto found = topic_of_.find(connection);
  if (found == topic_of_.end()) return;
  auto& number = topics_[static_cast<std::size_t>(found->second)].num_messages;
  number = number.value_or(0) + count;
}

void ChunkedBagReader::Forget() {
  topics_.clear();
  topic_of_.clear();
  chunks_.clear();
}

std::uint64_t ChunkedBagReader::AddScannedChunk(std::uint64_t position) {
  const std::size_t chunk = chunks_.size();
  chunks_.push_back({position, std::numeric_limits<std::int64_t>::max(), 0});
  ChunkHeader header;
  if (!HeaderOf(chunk, &header)) {
    chunks_.pop_back();
    return 0;
  }
  std::unordered_map<std::uint32_t, std::uint64_t> num_messages;
  std::int64_t start_ns = std::numeric_limits<std::int64_t>::max();
  const MessageVisitor visit = [&](std::uint32_t connection, std::int64_t record_ns, auto) {
    ++num_messages[connection];
    start_ns = std::min(start_ns, record_ns);
  };
  const auto is_known = [&](const auto& number) { return IsConnection(number.first); };
  const bool has_index = VisitIndex(header, visit);
  if (!has_index || !std::all_of(num_messages.begin(), num_messages.end(), is_known)) {
    num_messages.clear();
    // Not kept: the chunks that are played first are those at the start.
    const std::unique_ptr<Content> content = Unpack(chunk, header);
    if (content != nullptr) VisitMessages(content->bytes.get(), visit);
  }
  for (const auto& [connection, number] : num_messages) CountMessages(connection, number);
  chunks_.back().start_ns = start_ns;
  if (num_messages.empty()) chunks_.pop_back();
  return header.index_position;
}

std::int64_t ChunkedBagReader::start_ns() const {
  std::int64_t start_ns = std::numeric_limits<std::int64_t>::max();
  for (const ChunkPlace& chunk : chunks_) start_ns = std::min(start_ns, chunk.start_ns);
  return start_ns;
}

void ChunkedBagReader::Select(const std::vector<int>& topics) {
  CHECK_EQ(next_chunk_, 0u) << "Select() after Next()";
  is_wanted_.assign(topics_.size(), false);
  for (const int topic : topics) is_wanted_.at(static_cast<std::size_t>(topic)) = true;
  // A chunk that is listed twice would give its messages twice.
  std::sort(chunks_.begin(), chunks_.end(), [](const ChunkPlace& a, const ChunkPlace& b) {
    return std::tie(a.position, a.start_ns) < std::tie(b.position, b.start_ns);
  });
  chunks_.erase(std::unique(chunks_.begin(),
                            chunks_.end(),
                            [](const ChunkPlace& a, const ChunkPlace& b) {
                              return a.position == b.position;
                            }),
                chunks_.end());
  if (WasClockSetBack()) {
    TakeFileOrder();
    return;
  }
  std::stable_sort(chunks_.begin(), chunks_.end(), [](const ChunkPlace& a, const ChunkPlace& b) {
    return a.start_ns < b.start_ns;
  });
}

bool ChunkedBagReader::WasClockSetBack() {
  RecordClock starts;
  for (const ChunkPlace& chunk : chunks_) starts.Add(0, chunk.start_ns);
  if (!starts.WasSetBack()) return false;
  RecordClock clock;
  std::vector<StoredTime> messages;
  const MessageVisitor visit =
      [&](std::uint32_t connection, std::int64_t record_ns, std::uint64_t offset) {
        const auto topic = topic_of_.find(connection);
        if (topic == topic_of_.end() || !is_wanted_[static_cast<std::size_t>(topic->second)])
          return;
        messages.push_back({offset, topic->second, record_ns});
      };
  for (std::size_t chunk = 0; chunk < chunks_.size() && error_.empty(); ++chunk) {
    messages = {};
    ChunkHeader header;
    if (!HeaderOf(chunk, &header)) continue;
    if (!VisitIndex(header, visit)) {
      messages.clear();
      const std::unique_ptr<Content> content = Unpack(chunk, header);
      if (content != nullptr) VisitMessages(content->bytes.get(), visit);
    }
    AddInFileOrder(std::move(messages), &clock);
  }
  return clock.WasSetBack();
}

void ChunkedBagReader::TakeFileOrder() {
  is_in_file_order_ = true;
  std::sort(chunks_.begin(), chunks_.end(), [](const ChunkPlace& a, const ChunkPlace& b) {
    return a.position < b.position;
  });
  Warn("recorders whose clock was set",
       "the times of recording go back, as if the clock had been set; messages are taken in the "
       "order of the file");
}

bool ChunkedBagReader::HeaderOf(std::size_t chunk, ChunkHeader* header) {
  const ChunkPlace& place = chunks_[chunk];
  if (place.bare_size > 0) {
    header->data_position = place.position;
    header->stored_size = header->size = place.bare_size;
    return true;
  }
  std::string reason;
  if (ReadChunkHeader(place.position, header, &reason)) return true;
  Warn("damaged chunks",
       reason + " " + AtByte(place.position) + ", expected a chunk; it is passed over");
  return false;
}

// Chunks whose messages are shuffled finely are unpacked again and again, for as long as somebody
// who made the file on purpose likes. Real ones are unpacked once or twice.
bool ChunkedBagReader::SpendUnpacking(std::uint64_t size) {
  constexpr std::uint64_t kFree = std::uint64_t{512} << 20;
  constexpr std::uint64_t kBytesPerByte = 2000;
  unpacked_bytes_ += size;
  return unpacked_bytes_ <= kFree || unpacked_bytes_ / kBytesPerByte <= file_->size();
}

std::unique_ptr<ChunkedBagReader::Content> ChunkedBagReader::Unpack(std::size_t chunk,
                                                                    const ChunkHeader& header) {
  auto content = std::make_unique<Content>();
  content->chunk = chunk;
  const std::string where = "the chunk " + AtByte(chunks_[chunk].position);
  if (header.compression == Compression::kNone) {
    content->bytes =
        std::make_unique<FilePart>(file_.get(), header.data_position, header.stored_size);
    return content;
  }
  if (header.size > limits_.Chunk()) {
    Warn("chunks that are too large",
         where + " unpacks to " + std::to_string(header.size) + " bytes, expected at most " +
             std::to_string(limits_.Chunk()) +
             " (see input.max_message_bytes); its messages are passed over");
    return nullptr;
  }
  if (!SpendUnpacking(header.size)) {
    error_ = file_->name() +
             ": the messages of its chunks are shuffled so that reading them in "
             "order would unpack every chunk again and again";
    return nullptr;
  }
  const auto packed = file_->Read(header.data_position, header.stored_size, &buffer_);
  std::string reason = "cannot be read";
  if (!packed ||
      !Decompress(header.compression, *packed, header.size, &content->unpacked, &reason)) {
    Warn("damaged chunks",
         where + " is damaged or cut: " + reason + "; read up to its byte " +
             std::to_string(content->unpacked.size()));
  }
  content->bytes = std::make_unique<MemoryFile>(file_->name(), content->unpacked);
  CheckCrc(chunk, header, content->bytes.get());
  return content;
}

void ChunkedBagReader::CheckCrc(std::size_t chunk,
                                const ChunkHeader& header,
                                RandomAccessFile* bytes) {
  // What is cut has been warned of.
  if (!header.crc || bytes->size() != header.size) return;
  if (!checked_.insert(chunks_[chunk].position).second) return;
  const std::optional<std::uint32_t> crc = Crc32(bytes);
  if (!crc || *crc == *header.crc) return;
  Warn("chunks with a wrong checksum",
       "the chunk " + AtByte(chunks_[chunk].position) +
           " is not what its checksum says; it is read all the same");
}

void ChunkedBagReader::MakeRoom() {
  std::size_t used = 0;
  for (auto it = cache_.begin(); it != cache_.end();) {
    used += (*it)->unpacked.capacity();
    it = used > kCacheBytes / 2 || std::distance(cache_.begin(), it) >= 16 ? cache_.erase(it)
                                                                           : std::next(it);
  }
}

ChunkedBagReader::Content* ChunkedBagReader::Open(std::size_t chunk) {
  for (auto it = cache_.begin(); it != cache_.end(); ++it) {
    if ((*it)->chunk != chunk) continue;
    cache_.splice(cache_.begin(), cache_, it);
    return cache_.front().get();
  }
  ChunkHeader header;
  if (!HeaderOf(chunk, &header)) return nullptr;
  MakeRoom();
  std::unique_ptr<Content> content = Unpack(chunk, header);
  if (content == nullptr) return nullptr;
  cache_.push_front(std::move(content));
  return cache_.front().get();
}

// Puts the wanted messages of a chunk into the queue.
void ChunkedBagReader::Queue(std::size_t chunk) {
  std::vector<Entry> entries;
  std::vector<StoredTime> wanted;                      // in the first chunk
  std::vector<std::pair<std::uint64_t, bool>> places;  // of all messages, and whether it is wanted
  const MessageVisitor visit =
      [&](std::uint32_t connection, std::int64_t record_ns, std::uint64_t offset) {
        const auto topic = topic_of_.find(connection);
        const bool is_wanted =
            topic != topic_of_.end() && is_wanted_[static_cast<std::size_t>(topic->second)];
        if (is_wanted) {
          entries.push_back({record_ns, is_in_file_order_ ? 0 : record_ns, chunk, offset});
          if (next_chunk_ == 1) wanted.push_back({offset, topic->second, record_ns});
        }
        places.emplace_back(offset, is_wanted);
      };
  ChunkHeader header;
  if (!HeaderOf(chunk, &header)) return;
  if (!VisitIndex(header, visit)) {
    entries.clear();
    wanted.clear();
    places.clear();
    Content* const content = Open(chunk);
    if (content == nullptr) return;
    const std::uint64_t end = VisitMessages(content->bytes.get(), visit);
    if (end < content->bytes->size()) {
      Warn("damaged chunks",
           "the chunk " + AtByte(chunks_[chunk].position) + " is damaged or cut at its byte " +
               std::to_string(end) + "; the messages before are read");
    }
  }
  if (header.crc && header.compression == Compression::kNone &&
      MostIsWanted(std::move(places), header.size)) {
    if (Content* const content = Open(chunk)) CheckCrc(chunk, header, content->bytes.get());
  }
  // The starts of chunks do not tell of a step within the first one.
  if (next_chunk_ == 1 && !is_in_file_order_) {
    RecordClock clock;
    AddInFileOrder(std::move(wanted), &clock);
    const bool is_first_in_file =
        std::all_of(chunks_.begin(), chunks_.end(), [&](const ChunkPlace& other) {
          return other.position >= chunks_[chunk].position;
        });
    if (is_first_in_file && clock.WasSetBack()) {
      TakeFileOrder();
      for (Entry& entry : entries) entry.order_ns = 0;
    }
  }
  for (const Entry& entry : entries) {
    queue_.push_back(entry);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  }
}

MessageSource::Status ChunkedBagReader::Next(Message* message) {
  const Status status = NextOfQueue(message);
  if (read_error().empty()) return status;
  error_ = read_error();
  return Status::kError;
}

MessageSource::Status ChunkedBagReader::NextOfQueue(Message* message) {
  for (;;) {
    while (next_chunk_ < chunks_.size() &&
           (queue_.empty() ||
            (!is_in_file_order_ && chunks_[next_chunk_].start_ns <= queue_.front().record_ns))) {
      Queue(next_chunk_++);
      if (!error_.empty()) return Status::kError;
    }
    if (queue_.empty()) {
      warnings_.Finish();
      return Status::kEnd;
    }
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const Entry entry = queue_.back();
    queue_.pop_back();
    Content* const content = Open(entry.chunk);
    if (!error_.empty()) return Status::kError;
    if (content == nullptr) continue;

    std::uint32_t connection = 0;
    const Found found =
        ReadMessage(content->bytes.get(), entry.offset, &connection, &message->payload, &buffer_);
    const auto where = [&] {
      return "the message " + AtByte(entry.offset) + " of the chunk " +
             AtByte(chunks_[entry.chunk].position);
    };
    if (found == Found::kTooLarge) {
      error_ = file_->name() + ": " + where() + " is larger than " +
               std::to_string(limits_.message) + " bytes, see input.max_message_bytes";
      return Status::kError;
    }
    // Messages lie side by side: what adds up to more is listed on purpose.
    std::uint64_t& given = bytes_given_[entry.chunk];
    given += message->payload.size();
    const auto topic = topic_of_.find(connection);
    if (found == Found::kDamage || topic == topic_of_.end() ||
        !is_wanted_[static_cast<std::size_t>(topic->second)] || given > content->bytes->size()) {
      Warn("damaged messages", where() + " is damaged; it is passed over");
      continue;
    }
    message->topic = topic->second;
    message->record_ns = entry.record_ns;
    return Status::kMessage;
  }
}

}  // namespace radive
