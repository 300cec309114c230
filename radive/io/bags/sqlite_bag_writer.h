// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bags/message_writer.h"

struct sqlite3;
struct sqlite3_stmt;

namespace radive {

// Writes a rosbag 2 folder: FOLDER/metadata.yaml and FOLDER/NAME_0.db3, with NAME that of the
// folder.
class SqliteBagWriter : public MessageWriter {
 public:
  struct Options {
    bool zstd_messages = false;  // each payload as a zstd frame (compression_mode MESSAGE)
    std::string name = "";       // the file is NAME_0.db3; empty: the name of the folder
  };

  // Makes the folder. Null, with the place and the reason in `error`, when that fails or when it
  // holds a bag.
  static std::unique_ptr<SqliteBagWriter> Create(const std::filesystem::path& folder,
                                                 const Options& options,
                                                 std::string* error);

  int AddTopic(const MessageTopic& topic) override;
  bool Write(int topic,
             std::int64_t record_ns,
             std::string_view payload,
             std::string* error) override;
  bool Close(std::string* error) override;

 private:
  struct Free {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Free>;

  SqliteBagWriter(std::filesystem::path folder, const Options& options)
      : folder_(std::move(folder)), options_(options) {}

  bool Run(const std::string& sql);
  bool Step(sqlite3_stmt* statement);
  Statement Prepare(const std::string& sql);
  std::string Metadata() const;
  std::string FileName() const;

  const std::filesystem::path folder_;
  const Options options_;
  std::unique_ptr<sqlite3, Free> database_;
  Statement insert_;
  std::vector<MessageTopic> topics_;
  std::uint64_t num_messages_ = 0;
  std::int64_t start_ns_ = 0;
  std::int64_t end_ns_ = 0;
  std::string error_;  // the first; empty: none
};

}  // namespace radive
