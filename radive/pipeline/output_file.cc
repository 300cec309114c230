// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/output_file.h"

#include <cerrno>
#include <cstring>

namespace radive {

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

bool OutputFile::Open(const std::filesystem::path& path, std::string* error) {
  path_ = path;
  file_ = std::fopen(path_.c_str(), "wb");
  if (file_ == nullptr) SetFailure(errno);
  return Report(error);
}

void OutputFile::Write(const std::string& bytes) {
  if (file_ == nullptr || !failure_.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) SetFailure(errno);
}

bool OutputFile::Flush(std::string* error) {
  if (file_ != nullptr && failure_.empty() && std::fflush(file_) != 0) SetFailure(errno);
  return Report(error);
}

bool OutputFile::Close(std::string* error) {
  if (file_ != nullptr) {
    if (std::fclose(file_) != 0 && failure_.empty()) SetFailure(errno);
    file_ = nullptr;
  }
  return Report(error);
}

void OutputFile::SetFailure(int error_number) { failure_ = std::strerror(error_number); }

bool OutputFile::Report(std::string* error) const {
  if (failure_.empty()) return true;
  *error = path_.string() + ": cannot be written: " + failure_;
  return false;
}

}  // namespace radive
