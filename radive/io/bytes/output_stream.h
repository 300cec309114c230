// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

namespace radive {

// A file that grows by appending, and knows where it ends.
class OutputStream {
 public:
  // Null, with the file and the reason in `error`, when it cannot be made.
  static std::unique_ptr<OutputStream> Create(const std::filesystem::path& path,
                                              std::string* error) {
    auto stream = std::unique_ptr<OutputStream>(new OutputStream(path));
    return stream->Check(error) ? std::move(stream) : nullptr;
  }

  void Append(std::string_view bytes) {
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    size_ += bytes.size();
  }

  // Replaces bytes that were written.
  void Overwrite(std::uint64_t position, std::string_view bytes) {
    file_.seekp(static_cast<std::streamoff>(position));
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file_.seekp(0, std::ios::end);
  }

  // False, with the reason in `error`, when something could not be written.
  bool Check(std::string* error) {
    if (file_.good()) return true;
    *error = path_.string() + ": cannot be written";
    return false;
  }
  bool Close(std::string* error) {
    file_.close();
    return Check(error);
  }

  std::uint64_t size() const { return size_; }

 private:
  explicit OutputStream(std::filesystem::path path)
      : path_(std::move(path)), file_(path_, std::ios::binary | std::ios::trunc) {}

  const std::filesystem::path path_;
  std::ofstream file_;
  std::uint64_t size_ = 0;
};

}  // namespace radive
