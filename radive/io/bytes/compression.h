// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace radive {

// How the bytes of a chunk are packed: bzip2, LZ4 in its frame format, Zstandard.
enum class Compression { kNone, kBz2, kLz4, kZstd };

// "none", "bz2", "lz4", "zstd".
const char* NameOf(Compression compression);

// The other way round; an empty name is none too.
std::optional<Compression> CompressionOfName(std::string_view name);

// Unpacks `packed`, which should give `size` bytes, into `unpacked`. False, with the reason in
// `error`, when it does not; what was unpacked until then is kept. Memory grows with the bytes that
// really come out, so that a wrong size costs none; never more than `size` bytes are kept.
bool Decompress(Compression compression,
                std::string_view packed,
                std::uint64_t size,
                std::string* unpacked,
                std::string* error);

// Packs `bytes` into a stream of its own, which Decompress() and the other programs unpack.
std::string Compress(Compression compression, std::string_view bytes);

}  // namespace radive
