// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace radive {

// A file that is written bit by bit, whose errors are noticed.
class OutputFile {
 public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  bool Open(const std::filesystem::path& path, std::string* error);

  // Appends. A write error (a full disk) shows in Flush() and Close() and nowhere else.
  void Write(const std::string& bytes);

  // False when something could not be written so far; `error` names the file and the reason.
  bool Flush(std::string* error);

  bool Close(std::string* error);

 private:
  void SetFailure(int error_number);
  bool Report(std::string* error) const;

  std::FILE* file_ = nullptr;
  std::filesystem::path path_;
  std::string failure_;
};

}  // namespace radive
