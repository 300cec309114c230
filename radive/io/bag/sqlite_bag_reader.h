// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "radive/io/bag/message_source.h"

struct sqlite3;
struct sqlite3_blob;
struct sqlite3_stmt;

namespace radive {

// The SQLite file (.db3) of a rosbag 2: a table of topics and a table of messages. It is opened for
// reading only, and never changed.
class SqliteBagReader : public MessageSource {
 public:
  struct Form {
    std::string shown_name;      // in messages instead of the path; empty: the path
    bool zstd_messages = false;  // each payload is a zstd frame (compression_mode MESSAGE)
  };

  // Null, with the file and the reason in `error`, when `path` is no such file.
  static std::unique_ptr<SqliteBagReader> Open(const std::filesystem::path& path,
                                               const Form& form,
                                               const MessageLimits& limits,
                                               std::string* error);

  // The same from the bytes of the file, which must outlive the object.
  static std::unique_ptr<SqliteBagReader> OpenBytes(std::string_view bytes,
                                                    const Form& form,
                                                    const MessageLimits& limits,
                                                    std::string* error);

  void Select(const std::vector<int>& topics) override;
  Status Next(Message* message) override;
  std::int64_t start_ns() const override { return start_ns_; }
  std::string Description() const override { return "rosbag 2 file " + form_.shown_name; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
    void operator()(sqlite3_blob* blob) const;
  };
  using Database = std::unique_ptr<sqlite3, Close>;
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;
  using Blob = std::unique_ptr<sqlite3_blob, Close>;

  SqliteBagReader(Database database, Form form, const MessageLimits& limits);

  static std::unique_ptr<SqliteBagReader> Create(Database database,
                                                 const Form& form,
                                                 std::uint64_t file_size,
                                                 const MessageLimits& limits,
                                                 std::string* error);
  void LimitSteps(std::uint64_t file_size);
  Statement Prepare(const std::string& sql);
  bool IsPlainTable(const std::string& name);
  bool ReadTopics();
  bool CountMessages();
  std::string ReadPayload(std::int64_t row, bool* is_too_large);
  std::string Reason() const;

  std::int64_t num_steps_left_ = 0;  // of SQLite, in units of LimitSteps()
  // In this order, so that the database is closed last.
  const Database database_;
  const Form form_;
  const MessageLimits limits_;
  Statement messages_;
  Blob blob_;
  std::unordered_map<std::int64_t, int> topic_of_id_;
  std::string stored_;   // payload as it is in the file
  std::string payload_;  // payload that was packed
  std::int64_t start_ns_ = 0;
};

}  // namespace radive
