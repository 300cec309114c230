// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace radive {

// Reads a whole small file (at most 1 GiB, far more than any scan) into `content`. False, with the
// file and the reason in `error`, when it cannot be read, is no regular file, or is the small text
// that Git LFS leaves in place of data that were never fetched.
// `is_unreadable` says whether the operating system refused (a drive that is away, no permission, a
// broken disk), which says nothing of the content.
bool ReadWholeFile(const std::filesystem::path& path,
                   std::string* content,
                   std::string* error,
                   bool* is_unreadable = nullptr);

// True when the file starts like the text of a Git-LFS pointer, which it then says in `error`.
bool IsLfsPointer(const std::filesystem::path& path, std::string* error);

// Number of whole records of `record_size` bytes in a file of `file_size` bytes. Bytes behind the
// last one are ignored, with a line in `remarks` that calls the records `record_name`.
std::uint64_t CountRecords(std::uint64_t file_size,
                           std::size_t record_size,
                           const std::string& record_name,
                           std::vector<std::string>* remarks);

}  // namespace radive
