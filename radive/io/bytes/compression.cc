// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/compression.h"

#include <bzlib.h>
#include <glog/logging.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace radive {
namespace {

constexpr std::array<const char*, 4> kNames = {"none", "bz2", "lz4", "zstd"};

// Where a decoder writes: grows as it fills, up to one byte more than expected, by which a stream
// that is too long shows.
class Output {
 public:
  Output(std::uint64_t size, std::size_t packed_size, std::string* bytes)
      : limit_(size + 1), bytes_(bytes) {
    // Enough for data that pack as scans do, so that most chunks need no second allocation.
    bytes_->resize(static_cast<std::size_t>(std::min<std::uint64_t>(limit_, 8 * packed_size + 64)));
  }

  // Where to go on writing, and how much. False when all of the limit is written.
  bool Room(char** place, std::size_t* count) {
    if (written_ == bytes_->size()) {
      if (written_ == limit_) return false;
      bytes_->resize(static_cast<std::size_t>(std::min<std::uint64_t>(limit_, 2 * written_)));
    }
    *place = bytes_->data() + written_;
    *count = bytes_->size() - written_;
    return true;
  }
  void Written(std::size_t count) { written_ += count; }

  // Cuts what is too much. False, with the reason, when it is not the expected size.
  bool Finish(bool is_complete, std::string* error) {
    const std::uint64_t size = limit_ - 1;
    const std::uint64_t written = written_;
    bytes_->resize(static_cast<std::size_t>(std::min(written, size)));
    if (written > size) {
      *error = "unpacks to more than the " + std::to_string(size) + " bytes that it should";
      return false;
    }
    if (!is_complete) *error = "the packed data are cut off";
    if (is_complete && written < size) {
      *error =
          "unpacks to " + std::to_string(written) + " bytes instead of " + std::to_string(size);
    }
    return is_complete && written == size;
  }

 private:
  const std::uint64_t limit_;
  std::string* const bytes_;
  std::uint64_t written_ = 0;
};

bool DecompressLz4(std::string_view packed, Output* output, std::string* error) {
  LZ4F_dctx* raw = nullptr;
  CHECK_EQ(LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)), 0u);
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(
      raw, &LZ4F_freeDecompressionContext);
  std::size_t taken = 0;
  char* place = nullptr;
  std::size_t room = 0;
  while (output->Room(&place, &room)) {
    std::size_t in = packed.size() - taken;
    const std::size_t status =
        LZ4F_decompress(context.get(), place, &room, packed.data() + taken, &in, nullptr);
    output->Written(room);
    if (LZ4F_isError(status) != 0) {
      output->Finish(false, error);
      *error = std::string("lz4: ") + LZ4F_getErrorName(status);
      return false;
    }
    taken += in;
    if (status == 0) return output->Finish(true, error);
    if (in == 0 && room == 0) break;
  }
  return output->Finish(false, error);
}

bool DecompressBz2(std::string_view packed, Output* output, std::string* error) {
  bz_stream raw = {};
  CHECK_EQ(BZ2_bzDecompressInit(&raw, 0, 0), BZ_OK);
  const std::unique_ptr<bz_stream, int (*)(bz_stream*)> stream(&raw, &BZ2_bzDecompressEnd);
  raw.next_in = const_cast<char*>(packed.data());  // bzip2 does not write there
  raw.avail_in = static_cast<unsigned>(std::min<std::size_t>(packed.size(), 0xFFFFFFFFu));
  char* place = nullptr;
  std::size_t room = 0;
  while (output->Room(&place, &room)) {
    const unsigned in = raw.avail_in;
    raw.next_out = place;
    raw.avail_out = static_cast<unsigned>(std::min<std::size_t>(room, 1u << 30));
    const unsigned out = raw.avail_out;
    const int status = BZ2_bzDecompress(&raw);
    output->Written(out - raw.avail_out);
    if (status == BZ_STREAM_END) return output->Finish(true, error);
    if (status != BZ_OK) {
      output->Finish(false, error);
      *error = "bz2: the packed data are damaged (error " + std::to_string(status) + ")";
      return false;
    }
    if (raw.avail_in == in && raw.avail_out == out) break;
  }
  return output->Finish(false, error);
}

bool DecompressZstd(std::string_view packed,
                    std::uint64_t size,
                    Output* output,
                    std::string* error) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             &ZSTD_freeDStream);
  // A frame names its window, which is allocated before anything comes out.
  constexpr int kSmallestBound = 23;  // 8 MiB, which all but the highest levels keep to
  int window_log = kSmallestBound;
  while (window_log < 27 && (std::uint64_t{1} << window_log) < size) ++window_log;
  ZSTD_DCtx_setParameter(stream.get(), ZSTD_d_windowLogMax, window_log);
  ZSTD_inBuffer input = {packed.data(), packed.size(), 0};
  char* place = nullptr;
  std::size_t room = 0;
  while (output->Room(&place, &room)) {
    ZSTD_outBuffer out = {place, room, 0};
    const std::size_t before = input.pos;
    const std::size_t status = ZSTD_decompressStream(stream.get(), &out, &input);
    output->Written(out.pos);
    if (ZSTD_isError(status) != 0) {
      output->Finish(false, error);
      *error = std::string("zstd: ") + ZSTD_getErrorName(status);
      return false;
    }
    if (status == 0) return output->Finish(true, error);
    if (out.pos == 0 && input.pos == before) break;
  }
  return output->Finish(false, error);
}

std::string CompressLz4(std::string_view bytes) {
  // The reader of ROS 1 knows no other frames.
  LZ4F_preferences_t preferences = LZ4F_INIT_PREFERENCES;
  preferences.frameInfo.blockMode = LZ4F_blockIndependent;
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string packed(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
  CHECK_EQ(LZ4F_isError(size), 0u);
  packed.resize(size);
  return packed;
}

std::string CompressBz2(std::string_view bytes) {
  // The bound that the documentation of bzip2 gives.
  auto size = static_cast<unsigned>(bytes.size() + bytes.size() / 100 + 600);
  std::string packed(size, '\0');
  CHECK_EQ(BZ2_bzBuffToBuffCompress(packed.data(),
                                    &size,
                                    const_cast<char*>(bytes.data()),
                                    static_cast<unsigned>(bytes.size()),
                                    /*blockSize100k=*/9,
                                    /*verbosity=*/0,
                                    /*workFactor=*/0),
           BZ_OK);
  packed.resize(size);
  return packed;
}

std::string CompressZstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), /*level=*/3);
  CHECK_EQ(ZSTD_isError(size), 0u);
  packed.resize(size);
  return packed;
}

}  // namespace

const char* NameOf(Compression compression) {
  return kNames[static_cast<std::size_t>(compression)];
}

std::optional<Compression> CompressionOfName(std::string_view name) {
  if (name.empty()) return Compression::kNone;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<Compression>(i);
  }
  return std::nullopt;
}

bool Decompress(Compression compression,
                std::string_view packed,
                std::uint64_t size,
                std::string* unpacked,
                std::string* error) {
  if (compression == Compression::kNone) {
    const std::uint64_t kept = std::min<std::uint64_t>(size, packed.size());
    unpacked->assign(packed.substr(0, static_cast<std::size_t>(kept)));
    if (packed.size() == size) return true;
    *error = "has " + std::to_string(packed.size()) + " bytes instead of " + std::to_string(size);
    return false;
  }
  Output output(size, packed.size(), unpacked);
  switch (compression) {
    case Compression::kNone:
      break;
    case Compression::kBz2:
      return DecompressBz2(packed, &output, error);
    case Compression::kLz4:
      return DecompressLz4(packed, &output, error);
    case Compression::kZstd:
      return DecompressZstd(packed, size, &output, error);
  }
  LOG(FATAL) << "unknown compression";
  return false;
}

std::string Compress(Compression compression, std::string_view bytes) {
  switch (compression) {
    case Compression::kNone:
      return std::string(bytes);
    case Compression::kBz2:
      return CompressBz2(bytes);
    case Compression::kLz4:
      return CompressLz4(bytes);
    case Compression::kZstd:
      return CompressZstd(bytes);
  }
  LOG(FATAL) << "unknown compression";
  return {};
}

}  // namespace radive
