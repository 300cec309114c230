// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/record_file.h"

#include <array>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>

#include "radive/util/read_file.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FilePointer OpenFile(const std::filesystem::path& path) {
  return FilePointer(std::fopen(path.c_str(), "rb"), &std::fclose);
}

}  // namespace

bool IsLfsPointer(const std::filesystem::path& path, std::string* error) {
  constexpr std::string_view kStart = "version https://git-lfs";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  const FilePointer file = OpenFile(path);
  std::array<char, kStart.size()> start;
  if (file == nullptr || std::fread(start.data(), 1, start.size(), file.get()) != start.size() ||
      std::string_view(start.data(), start.size()) != kStart) {
    return false;
  }
  *error =
      path.string() + ": a Git-LFS pointer instead of the data; fetch them with 'git lfs pull'";
  return true;
}

bool ReadWholeFile(const std::filesystem::path& path,
                   std::string* content,
                   std::string* error,
                   bool* is_unreadable) {
  content->clear();
  bool ignored = false;
  bool& has_failed = is_unreadable != nullptr ? *is_unreadable : ignored;
  has_failed = false;
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::is_regular_file(status)) {
    *error = path.string() +
             ": cannot be opened: " + (failure ? SystemMessage(failure) : "no regular file");
    has_failed = static_cast<bool>(failure);
    return false;
  }
  if (IsLfsPointer(path, error)) return false;
  std::string reason;
  if (ReadFileBytes(path, kLargestFile, content, &reason)) return true;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  const bool is_too_large = !failure && size > kLargestFile;
  *error =
      path.string() + (is_too_large ? ": larger than 1 GiB, expected a single scan or a small table"
                                    : ": cannot be read: " + reason);
  has_failed = !is_too_large;
  return false;
}

std::uint64_t CountRecords(std::uint64_t file_size,
                           std::size_t record_size,
                           const std::string& record_name,
                           std::vector<std::string>* remarks) {
  if (const std::uint64_t tail = file_size % record_size; tail != 0) {
    remarks->push_back("the size of " + std::to_string(file_size) + " bytes is no multiple of " +
                       std::to_string(record_size) + " (" + record_name + "); the last " +
                       std::to_string(tail) + " are ignored");
  }
  return file_size / record_size;
}

}  // namespace radive
