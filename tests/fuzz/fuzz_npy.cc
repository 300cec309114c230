// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/npy.h"
#include "tests/fuzz/fuzz_table.h"

namespace {

bool ParseUnnamed(std::string_view bytes,
                  radive::PointTable* table,
                  std::vector<std::string>* remarks,
                  std::string* error) {
  return radive::ParseNpy(bytes, {}, table, remarks, error);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return radive::testing::FuzzPointParser(ParseUnnamed, data, size);
}
