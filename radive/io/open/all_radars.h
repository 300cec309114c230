// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/input_options.h"

namespace radive {

// One radar of a vehicle: its number, which sensor.mounts and the scans name it by, and the options
// that read it alone.
struct RadarInput {
  int number = 0;
  InputOptions options;
};

// The radars of the drive at `path` for input.radar: all, in the order of their numbers:
//   RadarScenes  those whose tables are in the folder, with their own numbers
//   HeRCULES     1 Continental, 2 Aeva
//   SNAIL-Radar  1 ars548/points, 2 eagleg7/enhanced (PCD)
//   bags         the topics that input.topic lists, from 1
//   point files  the folders that input.folder lists, from 1
// `options`: with the format that was found. Nothing, with the expectation in `error`, when there
// is only one radar, or nothing says which there are.
std::optional<std::vector<RadarInput>> ListRadars(const std::filesystem::path& path,
                                                  const InputOptions& options,
                                                  std::string* error);

}  // namespace radive
