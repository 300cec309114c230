// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace radive {

// A file that appears whole or not at all: it is written as ".NAME.partial" and gets its name in
// Commit(). Without Commit() the partial file stays behind, for what it is worth.
class OutputFile {
 public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  bool Open(const std::filesystem::path& folder, const std::string& name, std::string* error);

  // Appends. A write error (a full disk) shows in Flush() and Commit() and nowhere else.
  void Write(const std::string& bytes);

  // False when something could not be written so far; `error` names the file and the reason.
  bool Flush(std::string* error);

  // Closes the file and gives it its name, over an earlier file of that name.
  bool Commit(std::string* error);

  bool is_open() const { return file_ != nullptr; }

  static std::string PartialName(const std::string& name) { return "." + name + ".partial"; }

 private:
  void SetFailure(int error_number);
  bool Report(std::string* error) const;

  std::FILE* file_ = nullptr;
  std::filesystem::path path_;
  std::filesystem::path partial_path_;
  std::string failure_;
};

}  // namespace radive
