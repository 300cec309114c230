// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/sqlite_bag_writer.h"

#include <glog/logging.h>
#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

#include "radive/io/bytes/compression.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// In double quotes, for YAML.
std::string YamlText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

void SqliteBagWriter::Free::operator()(sqlite3* database) const { sqlite3_close(database); }
void SqliteBagWriter::Free::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

std::unique_ptr<SqliteBagWriter> SqliteBagWriter::Create(const fs::path& folder,
                                                         const Options& options,
                                                         std::string* error) {
  std::unique_ptr<SqliteBagWriter> writer(new SqliteBagWriter(folder, options));
  std::error_code failure;
  fs::create_directories(folder, failure);
  const fs::path file = folder / writer->FileName();
  if (failure || fs::exists(file)) {
    *error = folder.string() + ": " + (failure ? SystemMessage(failure) : "holds a bag already");
    return nullptr;
  }
  sqlite3* raw = nullptr;
  sqlite3_open(file.c_str(), &raw);
  writer->database_.reset(raw);
  // The tables of rosbag 2, release Humble. Without a journal, as its recorder writes them.
  writer->Run("PRAGMA journal_mode = OFF");
  writer->Run("PRAGMA synchronous = OFF");
  writer->Run("CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL)");
  writer->Run("INSERT INTO schema VALUES (3, 'humble')");
  writer->Run(
      "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, "
      "metadata TEXT NOT NULL)");
  writer->Run(
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
      "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
  writer->Run(
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
      "timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
  writer->Run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  writer->Run("BEGIN");
  writer->insert_ =
      writer->Prepare("INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)");
  *error = writer->error_;
  return error->empty() ? std::move(writer) : nullptr;
}

std::string SqliteBagWriter::FileName() const {
  if (!options_.name.empty()) return options_.name + "_0.db3";
  const fs::path name =
      folder_.has_filename() ? folder_.filename() : folder_.parent_path().filename();
  return name.string() + "_0.db3";
}

bool SqliteBagWriter::Run(const std::string& sql) {
  const int status = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (status != SQLITE_OK && error_.empty()) {
    error_ = (folder_ / FileName()).string() + ": " + sqlite3_errmsg(database_.get());
  }
  return status == SQLITE_OK;
}

SqliteBagWriter::Statement SqliteBagWriter::Prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK &&
      error_.empty()) {
    error_ = (folder_ / FileName()).string() + ": " + sqlite3_errmsg(database_.get());
  }
  return Statement(statement);
}

bool SqliteBagWriter::Step(sqlite3_stmt* statement) {
  const bool is_done = sqlite3_step(statement) == SQLITE_DONE;
  if (!is_done && error_.empty()) {
    error_ = (folder_ / FileName()).string() + ": " + sqlite3_errmsg(database_.get());
  }
  sqlite3_reset(statement);
  return is_done;
}

int SqliteBagWriter::AddTopic(const MessageTopic& topic) {
  topics_.push_back(topic);
  topics_.back().num_messages = 0;
  const Statement insert = Prepare("INSERT INTO topics VALUES (?, ?, ?, ?, '')");
  if (insert == nullptr) return static_cast<int>(topics_.size()) - 1;
  sqlite3_bind_int64(insert.get(), 1, static_cast<sqlite3_int64>(topics_.size()));
  int column = 2;
  for (const std::string& text : {topic.name, topic.type, topic.encoding}) {
    sqlite3_bind_text(insert.get(), column++, text.c_str(), -1, SQLITE_TRANSIENT);
  }
  Step(insert.get());
  return static_cast<int>(topics_.size()) - 1;
}

bool SqliteBagWriter::Write(int topic,
                            std::int64_t record_ns,
                            std::string_view payload,
                            std::string* error) {
  CHECK_GE(record_ns, 0);
  ++*topics_.at(static_cast<std::size_t>(topic)).num_messages;
  const std::string packed =
      options_.zstd_messages ? Compress(Compression::kZstd, payload) : std::string();
  if (options_.zstd_messages) payload = packed;
  sqlite3_bind_int64(insert_.get(), 1, topic + 1);
  sqlite3_bind_int64(insert_.get(), 2, record_ns);
  sqlite3_bind_blob64(insert_.get(), 3, payload.data(), payload.size(), SQLITE_STATIC);
  start_ns_ = num_messages_ == 0 ? record_ns : std::min(start_ns_, record_ns);
  end_ns_ = num_messages_ == 0 ? record_ns : std::max(end_ns_, record_ns);
  ++num_messages_;
  Step(insert_.get());
  *error = error_;
  return error_.empty();
}

std::string SqliteBagWriter::Metadata() const {
  const std::string packing = options_.zstd_messages ? "zstd" : "";
  std::string text =
      "rosbag2_bagfile_information:\n"
      "  version: 5\n"
      "  storage_identifier: sqlite3\n"
      "  duration:\n"
      "    nanoseconds: " +
      std::to_string(end_ns_ - start_ns_) +
      "\n"
      "  starting_time:\n"
      "    nanoseconds_since_epoch: " +
      std::to_string(start_ns_) +
      "\n"
      "  message_count: " +
      std::to_string(num_messages_) +
      "\n"
      "  topics_with_message_count:\n";
  for (const MessageTopic& topic : topics_) {
    text +=
        "    - topic_metadata:\n"
        "        name: " +
        YamlText(topic.name) +
        "\n"
        "        type: " +
        YamlText(topic.type) +
        "\n"
        "        serialization_format: " +
        YamlText(topic.encoding) +
        "\n"
        "        offered_qos_profiles: \"\"\n"
        "      message_count: " +
        std::to_string(topic.num_messages.value_or(0)) + "\n";
  }
  return text + "  compression_format: " + YamlText(packing) +
         "\n"
         "  compression_mode: " +
         YamlText(options_.zstd_messages ? "MESSAGE" : "") +
         "\n"
         "  relative_file_paths:\n"
         "    - " +
         YamlText(FileName()) + "\n";
}

bool SqliteBagWriter::Close(std::string* error) {
  insert_.reset();
  Run("COMMIT");
  database_.reset();
  const fs::path metadata = folder_ / "metadata.yaml";
  std::ofstream file(metadata, std::ios::binary);
  file << Metadata();
  file.close();
  if (!file && error_.empty()) error_ = metadata.string() + ": cannot be written";
  *error = error_;
  return error_.empty();
}

}  // namespace radive
