// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace radive {

// The decompressed copy of a file among the temporary files. It is removed with the object, and its
// name as soon as nobody needs it any more.
class UnpackedFile {
 public:
  // Decompresses the zstd file at `path`. Null, with the file and the reason in `error`, when that
  // fails, or when it holds more than kLargestRatio times its size.
  static std::unique_ptr<UnpackedFile> OfZstd(const std::filesystem::path& path,
                                              std::string* error);

  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  // No recording comes near; a file that does was made to fill the disk.
  static constexpr int kLargestRatio = 1000;

  explicit UnpackedFile(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path path_;
};

}  // namespace radive
