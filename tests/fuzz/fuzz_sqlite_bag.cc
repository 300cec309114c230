// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "radive/io/bag/sqlite_bag_reader.h"
#include "tests/fuzz/read_bag.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  radive::SqliteBagReader::Form form;
  form.shown_name = "bag";
  // The size of SQLite's pages is in the file; whether payloads are packed is not.
  form.zstd_messages = size % 2 == 1;
  radive::ReadBag([&](std::string* error) {
    return radive::SqliteBagReader::OpenBytes(bytes, form, radive::FuzzLimits(), error);
  });
  return 0;
}
