// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/read_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "radive/util/system_message.h"

namespace radive {
namespace {

constexpr int kLongestWait = 10000;  // for the next bytes of a pipe [ms]

class Descriptor {
 public:
  // A pipe without a writer would keep open() waiting, but for O_NONBLOCK.
  explicit Descriptor(const std::filesystem::path& path)
      : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  const int number_;
};

std::string TooLarge(std::uintmax_t max_bytes) {
  return "larger than " + std::to_string(max_bytes) + " bytes";
}

bool ReadToEnd(int file, std::uintmax_t max_bytes, std::string* bytes, std::string* reason) {
  constexpr std::size_t kLeast = 65536;
  std::size_t size = 0;
  while (true) {
    pollfd waiting = {file, POLLIN, 0};
    const int ready = poll(&waiting, 1, kLongestWait);
    if (ready == 0) {
      *reason = "gives no bytes for " + std::to_string(kLongestWait / 1000) + " s";
      return false;
    }
    if (size == bytes->size()) {
      const std::uintmax_t more = std::max<std::uintmax_t>(kLeast, 2 * size);
      bytes->resize(static_cast<std::size_t>(std::min(more, max_bytes + 1)));
    }
    const ssize_t count = ready < 0 ? -1 : read(file, bytes->data() + size, bytes->size() - size);
    if (count == 0) break;
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0) {
      *reason = SystemMessage(errno);
      return false;
    }
    size += static_cast<std::size_t>(count);
    if (size > max_bytes) {
      *reason = TooLarge(max_bytes);
      return false;
    }
  }
  bytes->resize(size);
  return true;
}

}  // namespace

bool ReadFileBytes(const std::filesystem::path& path,
                   std::uintmax_t max_bytes,
                   std::string* bytes,
                   std::string* reason) {
  bytes->clear();
  const Descriptor file(path);
  struct stat status {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0) {
    *reason = SystemMessage(errno);
  } else if (S_ISDIR(status.st_mode)) {
    *reason = "is a folder";
  } else if (static_cast<std::uintmax_t>(status.st_size) > max_bytes) {
    *reason = TooLarge(max_bytes);
  } else {
    // One byte more than a file of that size needs shows its end.
    bytes->resize(static_cast<std::size_t>(status.st_size) + 1);
    if (ReadToEnd(file.number(), max_bytes, bytes, reason)) return true;
  }
  bytes->clear();
  bytes->shrink_to_fit();
  return false;
}

}  // namespace radive
