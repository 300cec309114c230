// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "radive/io/bags/mcap_reader.h"
#include "tests/fuzz/read_bag.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  radive::ReadBag([&](std::string* error) {
    return radive::McapReader::Open(
        std::make_unique<radive::MemoryFile>("bag", bytes), radive::FuzzLimits(), error);
  });
  return 0;
}
