// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "radive/io/bags/sqlite_bag_reader.h"
#include "radive/io/bags/unpacking_message_source.h"
#include "tests/fuzz/read_bag.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  radive::ReadBag([&](std::string* error) -> std::unique_ptr<radive::MessageSource> {
    auto bag = radive::SqliteBagReader::OpenBytes(bytes, "bag", radive::FuzzLimits(), error);
    if (bag == nullptr) return nullptr;
    return std::make_unique<radive::UnpackingMessageSource>(std::move(bag), radive::FuzzLimits());
  });
  return 0;
}
