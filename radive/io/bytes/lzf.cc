// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/lzf.h"

#include <glog/logging.h>
#include <lzf.h>

#include <cerrno>
#include <limits>

namespace radive {
namespace {

// Three bytes of a stream repeat at most so many.
constexpr std::size_t kLongestRepeat = 264;

constexpr std::size_t kMostBytes = std::numeric_limits<unsigned int>::max();

}  // namespace

bool UnpackLzf(std::string_view packed,
               std::size_t size,
               std::vector<char>* unpacked,
               std::string* error) {
  unpacked->clear();
  if (size / kLongestRepeat > packed.size() || packed.size() > kMostBytes || size > kMostBytes) {
    *error =
        std::to_string(packed.size()) + " compressed bytes cannot hold " + std::to_string(size);
    return false;
  }
  if (packed.empty() || size == 0) {
    if (packed.empty() && size == 0) return true;
    *error =
        "compressed data: " + std::to_string(packed.size()) + " bytes for " + std::to_string(size);
    return false;
  }
  unpacked->resize(size);
  const unsigned int count = lzf_decompress(packed.data(),
                                            static_cast<unsigned int>(packed.size()),
                                            unpacked->data(),
                                            static_cast<unsigned int>(size));
  if (count == size) return true;
  const char* const what = count > 0        ? "less data than declared"
                           : errno == E2BIG ? "more data than declared"
                                            : "no LZF stream, or its end is missing";
  *error = std::string("compressed data: ") + what;
  unpacked->clear();
  return false;
}

std::string PackLzf(std::string_view bytes) {
  if (bytes.empty()) return "";
  // What cannot be packed grows by a byte in 32.
  std::string packed(bytes.size() + bytes.size() / 32 + 16, '\0');
  CHECK_LE(packed.size(), kMostBytes);
  const unsigned int size = lzf_compress(bytes.data(),
                                         static_cast<unsigned int>(bytes.size()),
                                         packed.data(),
                                         static_cast<unsigned int>(packed.size()));
  CHECK_GT(size, 0u) << "LZF took more room than it can";
  packed.resize(size);
  return packed;
}

}  // namespace radive
