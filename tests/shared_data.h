// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/shared_data_path.h"

namespace radive::testing {

// Folder of the real research-only data, which are not part of the project: the environment
// variable RADIVE_SHARED_DATA, or ../shared/data beside the checkout.
inline std::filesystem::path SharedData() {
  const char* from_environment = std::getenv("RADIVE_SHARED_DATA");
  return from_environment != nullptr ? from_environment : RADIVE_DEFAULT_SHARED_DATA;
}

}  // namespace radive::testing

// Skips the test, with a message, when the real data set `relative` is not on this machine.
#define RADIVE_SKIP_WITHOUT(relative)                                                      \
  if (!std::filesystem::exists(::radive::testing::SharedData() / (relative))) {            \
    GTEST_SKIP() << "real data absent: " << (::radive::testing::SharedData() / (relative)) \
                 << " (set RADIVE_SHARED_DATA)";                                           \
  }
