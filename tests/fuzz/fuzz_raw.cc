// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/datasets/raw_evidence.h"
#include "radive/io/scans/raw_source.h"
#include "tests/fuzz/fuzz_table.h"

// The first byte says which layout the records have.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<std::string_view, 6> kLayouts = {
      "hercules29", "mscrad17", "xyzdp5", "boreas_aeva40", "[x,y,_,doppler,rcs:int8]", "aeva29"};
  if (size == 0) return 0;
  const std::string_view layout_name = kLayouts[data[0] % kLayouts.size()];
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::string error, evidence;
  radive::ProvenLayout(bytes, &evidence);
  std::vector<std::string> remarks;
  radive::PointTable table;
  radive::RawFileReader reader(radive::KnownLayout(std::string(layout_name)));
  if (!reader.Read(bytes, 0, &table, &remarks, &error)) return 0;
  radive::testing::ConvertFuzzedTable(table, size);
  return 0;
}
