// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace radive {

// Bytes that parsers read at any place: a file, a part of one, or memory.
class RandomAccessFile {
 public:
  virtual ~RandomAccessFile() = default;

  // For messages.
  const std::string& name() const { return name_; }

  // [bytes], as it was when the file was opened.
  std::uint64_t size() const { return size_; }

  // Why bytes that are there could not be read, since the file was opened; empty: all could be. A
  // fault of the disk or of the network, which is no damage of the file.
  const std::string& read_error() const { return read_error_; }

  // The bytes [position, position + count), in `buffer` or wherever they are in memory; valid until
  // the buffer changes. Nothing when some of them are beyond the end or cannot be read: no more
  // memory is taken than there are bytes.
  virtual std::optional<std::string_view> Read(std::uint64_t position,
                                               std::uint64_t count,
                                               std::string* buffer) = 0;

 protected:
  RandomAccessFile(std::string name, std::uint64_t size) : name_(std::move(name)), size_(size) {}

  bool Contains(std::uint64_t position, std::uint64_t count) const {
    return position <= size_ && count <= size_ - position;
  }
  void SetReadError(const std::string& reason) { read_error_ = reason; }

 private:
  const std::string name_;
  const std::uint64_t size_;
  std::string read_error_;
};

// Opens a file for reading. Null, with the file and the reason in `error`, when it cannot be
// opened, is no regular file, or is the pointer that Git LFS leaves in place of data. Messages call
// it `shown_name` where that is given.
std::unique_ptr<RandomAccessFile> OpenRandomAccessFile(const std::filesystem::path& path,
                                                       std::string* error,
                                                       const std::string& shown_name = "");

// Bytes in memory, which must outlive the object.
class MemoryFile : public RandomAccessFile {
 public:
  MemoryFile(std::string name, std::string_view bytes)
      : RandomAccessFile(std::move(name), bytes.size()), bytes_(bytes) {}

  std::optional<std::string_view> Read(std::uint64_t position,
                                       std::uint64_t count,
                                       std::string* buffer) override;

 private:
  const std::string_view bytes_;
};

// The part [begin, begin + size) of another file, which must outlive the object. What of it is
// beyond the end of the file is cut off.
class FilePart : public RandomAccessFile {
 public:
  FilePart(RandomAccessFile* whole, std::uint64_t begin, std::uint64_t size);

  std::optional<std::string_view> Read(std::uint64_t position,
                                       std::uint64_t count,
                                       std::string* buffer) override;

 private:
  RandomAccessFile* const whole_;
  const std::uint64_t begin_;
};

// For messages: where in a file something is.
inline std::string AtByte(std::uint64_t position) { return "at byte " + std::to_string(position); }

}  // namespace radive
