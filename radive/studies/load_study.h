// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "radive/studies/study.h"

namespace radive {

// Where the relative paths of a study's inputs and references begin. Empty: at the study file.
struct StudyRoots {
  std::filesystem::path data;
  std::filesystem::path truth;  // empty: as `data`
};

// Reads a study file, docs/studies.md says what it holds. Every name and every setting is checked;
// whether settings fit each other shows in ListRuns(). Nothing on failure: `error` is then
// "FILE:LINE: what is wrong, and what was expected".
std::optional<Study> LoadStudy(const std::filesystem::path& file,
                               const StudyRoots& roots,
                               std::string* error);

}  // namespace radive
