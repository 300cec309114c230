// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/all_radars.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"

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

// The dataset that the options, and where they do not tell the folders below `path`, are of.
const Dataset* DatasetOf(const fs::path& path, const InputOptions& options) {
  std::error_code ignored;
  for (const Dataset& dataset : Datasets()) {
    for (const DatasetSensor& sensor : dataset.sensors) {
      if (!sensor.HasFormOf(options)) continue;
      const auto is_there = [&](const std::string& folder) {
        return fs::is_directory(path / folder, ignored);
      };
      if (sensor.open != nullptr ||
          std::any_of(sensor.folders.begin(), sensor.folders.end(), is_there)) {
        return &dataset;
      }
    }
  }
  return nullptr;
}

std::vector<RadarInput> RadarsOf(const Dataset& dataset, const InputOptions& options) {
  std::vector<RadarInput> radars;
  if (dataset.sensors.size() < 2) return radars;
  for (const DatasetSensor& sensor : dataset.sensors) {
    RadarInput& radar = radars.emplace_back();
    radar.number = static_cast<int>(radars.size());
    radar.options = options;
    radar.options.format = sensor.format;
    radar.options.layout = sensor.layouts.empty() ? "" : sensor.layouts.front();
    radar.options.folder = sensor.below.empty() ? sensor.folders.front() : "";
  }
  return radars;
}

}  // namespace

std::optional<std::vector<RadarInput>> ListRadars(const fs::path& path,
                                                  const InputOptions& options,
                                                  std::string* error) {
  std::vector<RadarInput> radars;
  std::string expected = "a list of folders in input.folder: [one, other]";
  const std::vector<std::string> folders = Words(options.folder);
  const Dataset* const dataset = DatasetOf(path, options);
  const bool says_which = dataset != nullptr && dataset->list_radars != nullptr;
  if (says_which) {
    expected = dataset->radar_files;
    auto found = dataset->list_radars(path, options, error);
    if (!found) return std::nullopt;
    radars = *std::move(found);
  } else if (IsBag(options.format)) {
    expected = "a list of topics in input.topic: [/one, /other]";
    radars = RadarsNamed(Words(options.topic), &InputOptions::topic, options);
  } else if (folders.size() > 1) {
    radars = RadarsNamed(folders, &InputOptions::folder, options);
  } else if (dataset != nullptr) {
    radars = RadarsOf(*dataset, options);
  }
  // Such a dataset is a drive of radars even where only one of them was fetched.
  if (radars.size() > 1 || (radars.size() == 1 && says_which)) return radars;
  *error = path.string() + ": input.radar is all, expected " + expected +
           (radars.empty() ? ", found none" : ", found one");
  return std::nullopt;
}

}  // namespace radive
