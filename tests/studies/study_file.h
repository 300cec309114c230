// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "radive/studies/load_study.h"

namespace radive::testing {

inline std::filesystem::path WriteTextFile(const std::filesystem::path& path,
                                           const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

// Loads a study from its text; the test fails when it is not valid.
inline Study LoadStudyText(const std::filesystem::path& folder, const std::string& text) {
  std::string error;
  const auto study = LoadStudy(WriteTextFile(folder / "study.yaml", text), {}, &error);
  EXPECT_TRUE(study.has_value()) << error;
  return study.value_or(Study());
}

}  // namespace radive::testing
