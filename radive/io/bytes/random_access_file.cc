// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/random_access_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

// An open file, closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

class DiskFile : public RandomAccessFile {
 public:
  DiskFile(std::string name, std::uint64_t size, Descriptor descriptor)
      : RandomAccessFile(std::move(name), size), descriptor_(std::move(descriptor)) {}

  std::optional<std::string_view> Read(std::uint64_t position,
                                       std::uint64_t count,
                                       std::string* buffer) override {
    if (!Contains(position, count)) return std::nullopt;
    // Walking from record to record reads a few bytes here and there: a system call for each would
    // take longer than all the rest.
    if (count <= kLargestSmallRead) {
      if (position < window_begin_ || position + count > window_begin_ + window_.size()) {
        window_begin_ = position;
        window_.resize(static_cast<std::size_t>(std::min(kWindow, size() - position)));
        if (!Fill(position, &window_)) {
          window_.clear();
          return std::nullopt;
        }
      }
      buffer->assign(window_,
                     static_cast<std::size_t>(position - window_begin_),
                     static_cast<std::size_t>(count));
      return *buffer;
    }
    buffer->resize(static_cast<std::size_t>(count));
    if (!Fill(position, buffer)) return std::nullopt;
    return *buffer;
  }

 private:
  static constexpr std::uint64_t kWindow = 16384;
  static constexpr std::uint64_t kLargestSmallRead = 2048;

  bool Fill(std::uint64_t position, std::string* bytes) {
    std::size_t done = 0;
    while (done < bytes->size()) {
      const ssize_t count = ::pread(descriptor_.number(),
                                    bytes->data() + done,
                                    bytes->size() - done,
                                    static_cast<off_t>(position + done));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) {
        SetReadError("cannot be read " + AtByte(position + done) + ": " + SystemMessage(errno));
      }
      if (count <= 0) return false;  // a file that has shrunk reads like one that is cut
      done += static_cast<std::size_t>(count);
    }
    return true;
  }

  const Descriptor descriptor_;
  std::uint64_t window_begin_ = 0;
  std::string window_;
};

}  // namespace

std::unique_ptr<RandomAccessFile> OpenRandomAccessFile(const std::filesystem::path& path,
                                                       std::string* error,
                                                       const std::string& shown_name) {
  // Without blocking on a named pipe, which is refused below.
  Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (descriptor.number() < 0) {
    *error = path.string() + ": cannot be opened: " + SystemMessage(errno);
    return nullptr;
  }
  struct stat status = {};
  if (::fstat(descriptor.number(), &status) != 0 || !S_ISREG(status.st_mode)) {
    *error = path.string() + ": no regular file";
    return nullptr;
  }
  if (IsLfsPointer(path, error)) return nullptr;
  return std::make_unique<DiskFile>(shown_name.empty() ? path.string() : shown_name,
                                    static_cast<std::uint64_t>(status.st_size),
                                    std::move(descriptor));
}

std::optional<std::string_view> MemoryFile::Read(std::uint64_t position,
                                                 std::uint64_t count,
                                                 std::string*) {
  if (!Contains(position, count)) return std::nullopt;
  return bytes_.substr(static_cast<std::size_t>(position), static_cast<std::size_t>(count));
}

FilePart::FilePart(RandomAccessFile* whole, std::uint64_t begin, std::uint64_t size)
    : RandomAccessFile(whole->name(),
                       begin <= whole->size() ? std::min(size, whole->size() - begin) : 0),
      whole_(whole),
      begin_(begin) {}

std::optional<std::string_view> FilePart::Read(std::uint64_t position,
                                               std::uint64_t count,
                                               std::string* buffer) {
  if (!Contains(position, count)) return std::nullopt;
  return whole_->Read(begin_ + position, count, buffer);
}

}  // namespace radive
