// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "radive/io/bytes/compression.h"

// The first byte says which packing the others have, the second what they should unpack to.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const auto compression = static_cast<radive::Compression>(data[0] % 4);
  const std::string_view packed(reinterpret_cast<const char*>(data) + 2, size - 2);
  const std::uint64_t unpacked_size = std::uint64_t{1} << data[1] % 20;
  std::string unpacked;
  std::string error;
  if (radive::Decompress(compression, packed, unpacked_size, &unpacked, &error) !=
      (unpacked.size() == unpacked_size && error.empty())) {
    __builtin_trap();
  }
  return 0;
}
