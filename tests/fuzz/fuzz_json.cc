// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/raflow_json.h"
#include "tests/fuzz/fuzz_table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  radive::RaFlowPair pair;
  std::string error;
  if (radive::ParseRaFlowPair(text, &pair, &error)) {
    radive::testing::ConvertFuzzedTable(pair.first, size);
    radive::testing::ConvertFuzzedTable(pair.second, size);
  } else if (error.empty()) {
    std::abort();
  }
  return 0;
}
