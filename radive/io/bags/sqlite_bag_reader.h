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

#include "radive/io/bags/message_source.h"

struct sqlite3;
struct sqlite3_blob;
struct sqlite3_stmt;

namespace radive {

// The SQLite file (.db3) of a rosbag 2: a table of topics and a table of messages. It is opened for
// reading only, and never changed.
class SqliteBagReader : public MessageSource {
 public:
  // `shown_name` stands in messages instead of the path where it is given.
  // Null, with the file and the reason in `error`, when `path` is no such file.
  static std::unique_ptr<SqliteBagReader> Open(const std::filesystem::path& path,
                                               const std::string& shown_name,
                                               const MessageLimits& limits,
                                               std::string* error);

  // The same from the bytes of the file, which must outlive the object.
  static std::unique_ptr<SqliteBagReader> OpenBytes(std::string_view bytes,
                                                    const std::string& shown_name,
                                                    const MessageLimits& limits,
                                                    std::string* error);

  void Select(const std::vector<int>& topics) override;
  Status Next(Message* message) override;
  std::int64_t start_ns() const override { return start_ns_; }
  std::string Description() const override { return "rosbag 2 file " + name_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
    void operator()(sqlite3_blob* blob) const;
  };
  using Database = std::unique_ptr<sqlite3, Close>;
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;
  using Blob = std::unique_ptr<sqlite3_blob, Close>;

  SqliteBagReader(Database database, std::string name, const MessageLimits& limits);

  static std::unique_ptr<SqliteBagReader> Create(Database database,
                                                 const std::string& shown_name,
                                                 std::uint64_t file_size,
                                                 const MessageLimits& limits,
                                                 std::string* error);
  void LimitSteps(std::uint64_t file_size);
  Statement Prepare(const std::string& sql);
  bool IsPlainTable(const std::string& name);
  bool ReadTopics();
  bool CountMessages();
  std::string ReadPayload(std::int64_t row, bool* is_error);
  std::string Reason() const;
  // Why the disk did not give bytes of the file, which is no damage of it; empty: it gave them.
  std::string ReadError() const;

  std::int64_t num_steps_left_ = 0;  // of SQLite, in units of LimitSteps()
  // In this order, so that the database is closed last.
  const Database database_;
  const std::string name_;  // for messages
  const MessageLimits limits_;
  Statement messages_;
  Blob blob_;
  std::unordered_map<std::int64_t, int> topic_of_id_;
  std::string payload_;
  std::int64_t start_ns_ = 0;
  bool is_in_file_order_ = false;  // the clock of the recorder was set back
};

}  // namespace radive
