// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/unpacked_file.h"

#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "radive/io/bytes/random_access_file.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Decompresses all frames of `compressed` into `file`. Returns what went wrong; empty: all is
// there.
std::string Unpack(RandomAccessFile* compressed, std::FILE* file, std::uint64_t largest) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             &ZSTD_freeDStream);
  std::string buffer;
  std::string decoded(ZSTD_DStreamOutSize(), '\0');
  std::uint64_t position = 0;
  std::uint64_t num_written = 0;
  std::size_t status = 1;
  while (position < compressed->size()) {
    const std::uint64_t count = std::min<std::uint64_t>(1 << 20, compressed->size() - position);
    const auto bytes = compressed->Read(position, count, &buffer);
    if (!bytes) return "cannot be read";
    position += count;
    ZSTD_inBuffer input = {bytes->data(), bytes->size(), 0};
    std::size_t produced = 0;
    // A full output may have more behind it, although all input was taken.
    while (input.pos < input.size || produced == decoded.size()) {
      ZSTD_outBuffer output = {decoded.data(), decoded.size(), 0};
      status = ZSTD_decompressStream(stream.get(), &output, &input);
      if (ZSTD_isError(status) != 0) return std::string("zstd: ") + ZSTD_getErrorName(status);
      produced = output.pos;
      num_written += produced;
      if (num_written > largest) {
        return "unpacks to more than " + std::to_string(largest) + " bytes; no bag does";
      }
      if (std::fwrite(decoded.data(), 1, produced, file) != produced) {
        return "cannot be unpacked into the folder of temporary files: " + SystemMessage(errno);
      }
    }
  }
  return status == 0 ? "" : "the zstd data are cut off";
}

}  // namespace

std::unique_ptr<UnpackedFile> UnpackedFile::OfZstd(const std::filesystem::path& path,
                                                   std::string* error) {
  const std::unique_ptr<RandomAccessFile> compressed = OpenRandomAccessFile(path, error);
  if (compressed == nullptr) return nullptr;
  std::error_code failure;
  std::string name = (std::filesystem::temp_directory_path(failure) / "radive_XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  const FilePointer file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb"), &std::fclose);
  if (file == nullptr) {
    *error = path.string() + ": cannot be unpacked to " + name + ": " + SystemMessage(errno);
    return nullptr;
  }
  std::unique_ptr<UnpackedFile> unpacked(new UnpackedFile(name));
  std::string reason = Unpack(compressed.get(), file.get(), compressed->size() * kLargestRatio);
  if (reason.empty() && std::fflush(file.get()) != 0) {
    reason = "cannot be unpacked to " + name + ": " + SystemMessage(errno);
  }
  if (reason.empty()) return unpacked;
  *error = path.string() + ": " + reason;
  return nullptr;
}

UnpackedFile::~UnpackedFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace radive
