// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/sqlite_bag_reader.h"

#include <glog/logging.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <system_error>
#include <utility>

#include "radive/io/bags/record_clock.h"
#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

// The path as the URI that lets SQLite open it for reading only.
std::string ReadOnlyUri(const std::filesystem::path& path) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path.string()) {
    if (c == '%' || c == '?' || c == '#') {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      uri += c;
    }
  }
  // A recorder that crashed may have left messages in a log beside the file. Without one, nothing
  // but the file itself is touched, so that it can lie in a folder where nothing may be written.
  std::error_code ignored;
  const bool has_log = std::filesystem::file_size(path.string() + "-wal", ignored) > 0 && !ignored;
  return uri + (has_log ? "?mode=ro" : "?mode=ro&immutable=1");
}

// Against files that were made to do harm: no code of the file runs, nothing large is allocated.
void Harden(sqlite3* database, const MessageLimits& limits) {
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  const auto largest = std::min<std::uint64_t>(limits.message + 4096, 1u << 30);
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, static_cast<int>(largest));
}

std::string Text(sqlite3_stmt* statement, int column) {
  const auto* const text = sqlite3_column_text(statement, column);
  const int size = sqlite3_column_bytes(statement, column);
  return text == nullptr
             ? ""
             : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
}

}  // namespace

void SqliteBagReader::Close::operator()(sqlite3* database) const { sqlite3_close(database); }
void SqliteBagReader::Close::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}
void SqliteBagReader::Close::operator()(sqlite3_blob* blob) const { sqlite3_blob_close(blob); }

SqliteBagReader::SqliteBagReader(Database database, std::string name, const MessageLimits& limits)
    : database_(std::move(database)), name_(std::move(name)), limits_(limits) {}

std::unique_ptr<SqliteBagReader> SqliteBagReader::Open(const std::filesystem::path& path,
                                                       const std::string& shown_name,
                                                       const MessageLimits& limits,
                                                       std::string* error) {
  const std::string name = shown_name.empty() ? path.string() : shown_name;
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    *error = name + ": " + (failure ? SystemMessage(failure) : "no regular file");
    return nullptr;
  }
  if (IsLfsPointer(path, error)) return nullptr;
  sqlite3* raw = nullptr;
  const int status = sqlite3_open_v2(ReadOnlyUri(path).c_str(),
                                     &raw,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX,
                                     nullptr);
  Database database(raw);
  if (status != SQLITE_OK) {
    *error = name + ": cannot be opened: " + sqlite3_errstr(status);
    return nullptr;
  }
  const std::uint64_t file_size = std::filesystem::file_size(path, failure);
  return Create(std::move(database), name, failure ? 0 : file_size, limits, error);
}

std::unique_ptr<SqliteBagReader> SqliteBagReader::OpenBytes(std::string_view bytes,
                                                            const std::string& shown_name,
                                                            const MessageLimits& limits,
                                                            std::string* error) {
  sqlite3* raw = nullptr;
  CHECK_EQ(sqlite3_open_v2(":memory:", &raw, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  Database database(raw);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  // SQLite does not write there: it is told that the bytes are read-only.
  auto* const data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  if (sqlite3_deserialize(raw, "main", data, size, size, SQLITE_DESERIALIZE_READONLY) !=
      SQLITE_OK) {
    *error = shown_name + ": no SQLite file";
    return nullptr;
  }
  return Create(std::move(database), shown_name, bytes.size(), limits, error);
}

std::unique_ptr<SqliteBagReader> SqliteBagReader::Create(Database database,
                                                         const std::string& shown_name,
                                                         std::uint64_t file_size,
                                                         const MessageLimits& limits,
                                                         std::string* error) {
  Harden(database.get(), limits);
  std::unique_ptr<SqliteBagReader> reader(
      new SqliteBagReader(std::move(database), shown_name, limits));
  reader->LimitSteps(file_size);
  if (reader->IsPlainTable("topics") && reader->IsPlainTable("messages") && reader->ReadTopics() &&
      reader->CountMessages()) {
    return reader;
  }
  *error = shown_name + ": " + reader->error_;
  return nullptr;
}

// Pages that refer to each other in a loop would go on for ever. A row takes some ten steps of
// SQLite's machine and at least as many bytes.
void SqliteBagReader::LimitSteps(std::uint64_t file_size) {
  constexpr int kStepsAtATime = 10000;
  constexpr std::uint64_t kStepsPerByte = 20;
  num_steps_left_ = static_cast<std::int64_t>(100 + kStepsPerByte * file_size / kStepsAtATime);
  const auto count = [](void* left) { return --*static_cast<std::int64_t*>(left) < 0 ? 1 : 0; };
  sqlite3_progress_handler(database_.get(), kStepsAtATime, count, &num_steps_left_);
}

std::string SqliteBagReader::Reason() const {
  return std::string("cannot be read as a rosbag 2 file: ") + sqlite3_errmsg(database_.get());
}

// SQLite itself calls most of these errors damage, too.
std::string SqliteBagReader::ReadError() const {
  int number = 0;
  sqlite3_file_control(database_.get(), "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return number == 0 ? "" : "cannot be read: " + SystemMessage(number);
}

// Null, with the reason in error_, when the tables or their columns are not there.
SqliteBagReader::Statement SqliteBagReader::Prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const int status = sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr);
  if (status != SQLITE_OK) error_ = Reason();
  return Statement(statement);
}

// A view or a virtual table could compute for ever what a table holds.
bool SqliteBagReader::IsPlainTable(const std::string& name) {
  const Statement statement = Prepare(
      "SELECT 1 FROM sqlite_master WHERE name = ? AND type = 'table' AND rootpage > 0 "
      "AND sql NOT LIKE '%GENERATED%' AND sql NOT LIKE '%AS (%'");
  if (statement == nullptr) return false;
  sqlite3_bind_text(statement.get(), 1, name.c_str(), -1, SQLITE_TRANSIENT);
  const int status = sqlite3_step(statement.get());
  if (status == SQLITE_ROW) return true;
  error_ = status == SQLITE_DONE
               ? "has no table '" + name + "', expected a rosbag 2 file with topics and messages"
               : Reason();
  return false;
}

bool SqliteBagReader::ReadTopics() {
  // By the names of the columns: their number differs from release to release.
  const Statement statement =
      Prepare("SELECT id, name, type, serialization_format FROM topics ORDER BY id");
  if (statement == nullptr) return false;
  int status = SQLITE_OK;
  while ((status = sqlite3_step(statement.get())) == SQLITE_ROW) {
    topic_of_id_[sqlite3_column_int64(statement.get(), 0)] = static_cast<int>(topics_.size());
    topics_.push_back({Text(statement.get(), 1),
                       Text(statement.get(), 2),
                       Text(statement.get(), 3),
                       std::uint64_t{0}});
  }
  if (status != SQLITE_DONE) error_ = Reason();
  return status == SQLITE_DONE;
}

bool SqliteBagReader::CountMessages() {
  const Statement messages = Prepare("SELECT topic_id, timestamp FROM messages ORDER BY rowid");
  if (messages == nullptr) return false;
  start_ns_ = std::numeric_limits<std::int64_t>::max();
  RecordClock clock;
  int status = SQLITE_OK;
  while ((status = sqlite3_step(messages.get())) == SQLITE_ROW) {
    start_ns_ = std::min<std::int64_t>(start_ns_, sqlite3_column_int64(messages.get(), 1));
    const auto topic = topic_of_id_.find(sqlite3_column_int64(messages.get(), 0));
    if (topic == topic_of_id_.end()) continue;
    ++*topics_[static_cast<std::size_t>(topic->second)].num_messages;
    clock.Add(static_cast<std::uint64_t>(topic->second), sqlite3_column_int64(messages.get(), 1));
  }
  is_in_file_order_ = clock.WasSetBack();
  if (is_in_file_order_) {
    warnings_.Add("recorders whose clock was set",
                  name_ +
                      ": the times of recording go back, as if the clock had been set; "
                      "messages are taken in the order of the file");
  }
  if (status == SQLITE_DONE) return true;
  error_ = ReadError();
  if (!error_.empty()) return false;
  // What the index of the messages still finds can be read all the same.
  warnings_.Add("damaged files", name_ + ": is damaged or cut: " + Reason());
  for (MessageTopic& topic : topics_) topic.num_messages.reset();
  start_ns_ = std::numeric_limits<std::int64_t>::min();
  return true;
}

void SqliteBagReader::Select(const std::vector<int>& topics) {
  CHECK(messages_ == nullptr) << "Select() after Next()";
  std::string ids;
  for (const auto& [id, topic] : topic_of_id_) {
    if (std::find(topics.begin(), topics.end(), topic) == topics.end()) continue;
    ids += (ids.empty() ? "" : ",") + std::to_string(id);
  }
  // The payloads are read one by one: in this query a missing index would sort them all.
  messages_ = Prepare("SELECT rowid, topic_id, timestamp FROM messages WHERE topic_id IN (" + ids +
                      ") ORDER BY " + (is_in_file_order_ ? "rowid" : "timestamp, rowid"));
}

// Reads the payload of a row of `messages`. Returns what is wrong with it, and whether the bag
// cannot be read any further; empty: nothing.
std::string SqliteBagReader::ReadPayload(std::int64_t row, bool* is_error) {
  sqlite3_blob* raw = blob_.get();
  int status = SQLITE_OK;
  if (raw == nullptr) {
    status = sqlite3_blob_open(database_.get(), "main", "messages", "data", row, 0, &raw);
    blob_.reset(raw);
  } else {
    status = sqlite3_blob_reopen(raw, row);
  }
  if (status == SQLITE_OK) {
    const auto size = static_cast<std::size_t>(sqlite3_blob_bytes(raw));
    *is_error = size > limits_.message;
    if (*is_error) {
      return "is larger than " + std::to_string(limits_.message) +
             " bytes, see input.max_message_bytes";
    }
    payload_.resize(size);
    status = sqlite3_blob_read(raw, payload_.data(), static_cast<int>(size), 0);
  }
  if (status == SQLITE_OK) return "";
  const std::string damage = sqlite3_errmsg(database_.get());
  blob_.reset();  // it cannot be moved to another row any more
  const std::string read_error = ReadError();
  *is_error = !read_error.empty();
  return *is_error ? read_error : "is damaged: " + damage;
}

MessageSource::Status SqliteBagReader::Next(Message* message) {
  if (messages_ == nullptr) {
    error_ = name_ + ": " + error_;
    return Status::kError;
  }
  int status = SQLITE_OK;
  while ((status = sqlite3_step(messages_.get())) == SQLITE_ROW) {
    const std::int64_t row = sqlite3_column_int64(messages_.get(), 0);
    const std::string where = name_ + ": message " + std::to_string(row) + " ";
    message->topic = topic_of_id_[sqlite3_column_int64(messages_.get(), 1)];
    message->record_ns = sqlite3_column_int64(messages_.get(), 2);
    bool is_error = false;
    if (std::string reason = ReadPayload(row, &is_error); !reason.empty()) {
      if (is_error) {
        error_ = where + reason;
        return Status::kError;
      }
      warnings_.Add("damaged messages in " + name_, where + reason + "; it is passed over");
      continue;
    }
    message->payload = payload_;
    return Status::kMessage;
  }
  if (const std::string read_error = ReadError(); !read_error.empty()) {
    error_ = name_ + ": " + read_error;
    return Status::kError;
  }
  if (status != SQLITE_DONE) {
    warnings_.Add("damaged files",
                  name_ + ": is damaged or cut: " + Reason() + "; read up to there");
  }
  warnings_.Finish();
  messages_ = Prepare("SELECT 1 WHERE 0");  // a further Next() gives the end again
  return Status::kEnd;
}

}  // namespace radive
