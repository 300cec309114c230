// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/scan_stamps.h"

#include <charconv>
#include <cstddef>
#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
std::optional<std::int64_t> ParseInteger(std::string_view text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

bool ParseStampLines(std::string_view text,
                     bool is_trajectory,
                     const std::string& place,
                     std::vector<std::int64_t>* stamps_ns,
                     std::string* error) {
  struct Entry {
    int line;
    std::string_view text;
  };
  std::vector<Entry> entries;
  bool are_seconds = is_trajectory;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    line = TrimBlanks(line);
    if (line.empty() || line.front() == '#') continue;
    if (is_trajectory) line = line.substr(0, line.find_first_of(" \t"));
    are_seconds = are_seconds || line.find_first_of(".eE") != std::string_view::npos;
    entries.push_back({lines.number(), line});
  }
  stamps_ns->clear();
  for (const Entry& entry : entries) {
    const std::optional<std::int64_t> stamp =
        are_seconds ? ParseStamp(entry.text) : ParseInteger(entry.text);
    if (!stamp) {
      *error = place + ":" + std::to_string(entry.line) +
               ": expected one stamp, integer nanoseconds or decimal seconds, found " +
               Quoted(entry.text);
      return false;
    }
    stamps_ns->push_back(*stamp);
  }
  return true;
}

bool ReadStampFile(const std::filesystem::path& path,
                   std::vector<std::int64_t>* stamps_ns,
                   std::string* error) {
  std::string text;
  const bool is_trajectory = path.filename() == "ref_poses.txt";
  return ReadWholeFile(path, &text, error) &&
         ParseStampLines(text, is_trajectory, path.string(), stamps_ns, error);
}

std::optional<std::int64_t> StampOfStem(std::string_view stem) {
  if (stem.empty() || stem.front() < '1' || stem.front() > '9') return std::nullopt;
  if (const std::size_t point = stem.find('.'); point != std::string_view::npos) {
    if (stem.size() - point != 10 || stem.find_first_not_of("0123456789.") != stem.npos) {
      return std::nullopt;
    }
    return ParseStamp(stem);
  }
  const std::optional<std::int64_t> value = ParseInteger(stem);
  if (!value) return std::nullopt;
  switch (stem.size()) {
    case 18:
    case 19:
      return *value;
    case 15:
    case 16:
      return ParseStamp(stem, -6);
    case 12:
    case 13:
      return ParseStamp(stem, -3);
    default:
      return std::nullopt;
  }
}

}  // namespace radive
