// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// An integer without sign, point or exponent, apart from a leading minus. Nothing otherwise.
std::optional<std::int64_t> ParseInteger(std::string_view text);

// Reads a file with one stamp a line into `stamps_ns` [ns]; what follows the stamp after a blank is
// not looked at in ref_poses.txt, a trajectory. Integers are nanoseconds; as soon as
// one line of the file has a decimal point or an exponent, all lines are seconds. Empty lines and
// lines that start with # are left out. False, with file, line and expectation in `error`, when the
// file cannot be read or a line is something else.
bool ReadStampFile(const std::filesystem::path& path,
                   std::vector<std::int64_t>* stamps_ns,
                   std::string* error);

// The same with the text of such a file; `place` stands for its name in messages.
bool ParseStampLines(std::string_view text,
                     bool is_trajectory,
                     const std::string& place,
                     std::vector<std::int64_t>* stamps_ns,
                     std::string* error);

// The time that the name of a scan file stands for: 18 or 19 digits are nanoseconds, 15 or 16
// microseconds, 12 or 13 milliseconds since an epoch; SECONDS.NANOSECONDS with all nine digits are
// that. Nothing for other names, and for numbers with leading zeros, which are positions. `stem` is
// the name without its extension.
std::optional<std::int64_t> StampOfStem(std::string_view stem);

}  // namespace radive
