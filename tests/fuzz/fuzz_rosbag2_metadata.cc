// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <string>

#include "radive/io/bags/rosbag2_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  radive::Rosbag2Metadata metadata;
  std::string error;
  radive::ParseRosbag2Metadata(
      std::string(reinterpret_cast<const char*>(data), size), &metadata, &error);
  return 0;
}
