// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/all_radars.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/radarscenes_hdf5.h"
#include "radive/io/datasets/radarscenes_source.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
using Format = InputOptions::Format;

// The words of "[a, b]" or "a, b".
std::vector<std::string> Words(std::string_view list) {
  list = TrimBlanks(list);
  if (list.size() >= 2 && list.front() == '[' && list.back() == ']') {
    list = list.substr(1, list.size() - 2);
  }
  std::vector<std::string> words;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = TrimBlanks(list.substr(0, comma));
    if (!word.empty()) words.emplace_back(word);
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return words;
}

bool IsBag(Format format) {
  return format == Format::kRosbag1 || format == Format::kRosbag2 || format == Format::kMcap;
}

// A radar for each of the words, which one of the options then holds alone.
std::vector<RadarInput> RadarsNamed(const std::vector<std::string>& words,
                                    std::string InputOptions::*option,
                                    const InputOptions& options) {
  std::vector<RadarInput> radars;
  for (const std::string& word : words) {
    radars.push_back({static_cast<int>(radars.size()) + 1, options});
    radars.back().options.*option = word;
  }
  return radars;
}

std::vector<RadarInput> HerculesRadars(const InputOptions& options) {
  std::vector<RadarInput> radars(2, {1, options});
  radars[0].options.format = Format::kHercules;
  radars[0].options.layout.clear();
  radars[0].options.folder.clear();
  radars[1].number = 2;
  radars[1].options.format = Format::kRaw;
  radars[1].options.layout = "aeva";
  radars[1].options.folder = "LiDAR/Aeva";
  return radars;
}

// Nothing, with the reason in `error`, when the file with the radars cannot be read.
std::optional<std::vector<RadarInput>> RadarScenesRadars(const fs::path& path,
                                                         const InputOptions& options,
                                                         std::string* error) {
  const std::optional<fs::path> file = FindRadarScenesHdf5(path, options.folder);
  const std::optional<std::vector<int>> numbers =
      file ? RadarsOfRadarScenesHdf5(*file, error) : RadarsOfRadarScenes(path / options.folder);
  if (!numbers) return std::nullopt;
  std::vector<RadarInput> radars;
  for (const int number : *numbers) {
    radars.push_back({number, options});
    radars.back().options.radar = std::to_string(number);
  }
  return radars;
}

}  // namespace

std::optional<std::vector<RadarInput>> ListRadars(const fs::path& path,
                                                  const InputOptions& options,
                                                  std::string* error) {
  std::error_code ignored;
  const auto holds = [&](const char* folder) { return fs::is_directory(path / folder, ignored); };
  std::vector<RadarInput> radars;
  std::string expected = "a list of folders in input.folder: [one, other]";
  const bool is_snail = options.format == Format::kPcd && holds("ars548/points");
  const std::vector<std::string> folders = Words(options.folder);
  if (options.format == Format::kRadarScenes) {
    expected = "radar1_scans.csv, radar2_scans.csv, ...";
    auto found = RadarScenesRadars(path, options, error);
    if (!found) return std::nullopt;
    radars = *std::move(found);
  } else if (IsBag(options.format)) {
    expected = "a list of topics in input.topic: [/one, /other]";
    radars = RadarsNamed(Words(options.topic), &InputOptions::topic, options);
  } else if (folders.size() > 1) {
    radars = RadarsNamed(folders, &InputOptions::folder, options);
  } else if (options.format == Format::kHercules || LowerCase(options.layout) == "aeva") {
    radars = HerculesRadars(options);
  } else if (is_snail) {
    radars = RadarsNamed({"ars548/points", "eagleg7/enhanced"}, &InputOptions::folder, options);
  }
  // RadarScenes is a drive of radars even where only one of them was fetched.
  if (radars.size() > 1 || (radars.size() == 1 && options.format == Format::kRadarScenes)) {
    return radars;
  }
  *error = path.string() + ": input.radar is all, expected " + expected +
           (radars.empty() ? ", found none" : ", found one");
  return std::nullopt;
}

}  // namespace radive
