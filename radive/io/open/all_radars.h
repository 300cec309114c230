// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/datasets/dataset.h"
#include "radive/io/scans/input_options.h"

namespace radive {

// The radars of the drive at `path` for input.radar: all, in the order of their numbers:
//   datasets     as their rows have them: of RadarScenes those whose tables are in the folder, of
//                HeRCULES 1 the Continental and 2 the Aeva, of SNAIL-Radar 1 the ARS548, 2 the
//                Eagle
//   bags         the topics that input.topic lists, from 1
//   point files  the folders that input.folder lists, from 1
// `options`: with the format that was found. Nothing, with the expectation in `error`, when there
// is only one radar, or nothing says which there are.
std::optional<std::vector<RadarInput>> ListRadars(const std::filesystem::path& path,
                                                  const InputOptions& options,
                                                  std::string* error);

}  // namespace radive
