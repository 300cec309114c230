// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/scans/stamp_sequence.h"

namespace radive {

// An integer without sign, point or exponent, apart from a leading minus. Nothing otherwise.
std::optional<std::int64_t> ParseInteger(std::string_view text);

// Reads a file with one stamp per line, in the unit that ReadStampSequence() finds. Of lines with
// several columns those with the stamps are found: an index or the like beside them does not
// matter, and seconds and nanoseconds may be apart. ref_poses.txt is a trajectory: seconds, and
// what follows the first blank is not looked at. Empty lines, lines that start with # and a header
// in the first line are left out. `rate` is for counters. Nothing, with file, line and expectation
// in `error`, when the file cannot be read or a line is something else.
std::optional<StampSequence> ReadStampFile(const std::filesystem::path& path,
                                           double rate,
                                           std::string* error);

// The same with the text of such a file; `place` stands for its name in messages.
std::optional<StampSequence> ParseStampLines(std::string_view text,
                                             bool is_trajectory,
                                             double rate,
                                             const std::string& place,
                                             std::string* error);

}  // namespace radive
