// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// docs/paper.md says what configs/paper_*.yaml are. RADIVE_SOURCE is the project, from CMake.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "radive/config/load_config.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = RADIVE_SOURCE;

std::string TextOf(const fs::path& file) {
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

using Settings = std::map<std::string, std::string>;  // "stage.field" and value

Settings SettingsOf(const std::string& yaml_path) {
  std::string error;
  std::optional<RunConfig> config = LoadRunConfig(yaml_path, "", &error);
  EXPECT_TRUE(config) << error;
  Settings settings;
  for (const auto& [stage, fields] : config->Stages()) {
    for (const OptionField& field : fields) settings[stage + "." + field.name] = field.ToString();
  }
  return settings;
}

// A cell of the table of docs/paper.md: what stands in back quotes, and the word before.
struct Quoted {
  std::string sensor;  // "dense", "sparse", or empty: both
  std::string text;
};

std::vector<Quoted> SettingsOfPage(const std::string& page) {
  std::vector<Quoted> all;
  std::istringstream lines(page);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind("| ", 0) != 0) continue;
    // Up to the next semicolon, or the end of the cell, a word holds.
    std::string sensor;
    const std::regex part("`([a-z_]+\\.[a-z_]+=[^`]*)`|\\b(dense|sparse) `|;| \\| ");
    std::string rest = line;
    std::smatch match;
    while (std::regex_search(rest, match, part)) {
      std::string::difference_type length = match.length();
      if (match[2].matched) {
        sensor = match[2];
        --length;  // the quote begins the setting
      } else if (match[1].matched) {
        all.push_back({sensor, match[1]});
      } else {
        sensor.clear();
      }
      rest = rest.substr(static_cast<std::size_t>(match.position() + length));
    }
  }
  return all;
}

TEST(PaperConfig, EffectiveSettingsAreThoseOfThePage) {
  const std::vector<Quoted> quoted = SettingsOfPage(TextOf(kSource / "docs/paper.md"));
  EXPECT_GT(quoted.size(), 60u);
  const Settings defaults = SettingsOf("");
  for (const std::string sensor : {"dense", "sparse"}) {
    const Settings settings =
        SettingsOf((kSource / "configs" / ("paper_" + sensor + ".yaml")).string());
    Settings page;
    for (const Quoted& entry : quoted) {
      if (!entry.sensor.empty() && entry.sensor != sensor) continue;
      const std::size_t equals = entry.text.find('=');
      page[entry.text.substr(0, equals)] = entry.text.substr(equals + 1);
    }
    for (const auto& [name, value] : page) {
      ASSERT_EQ(settings.count(name), 1u) << name;
      EXPECT_THAT(settings.at(name), ::testing::AnyOf(value, "\"" + value + "\""))
          << name << " of paper_" << sensor << ".yaml";
    }
    for (const auto& [name, value] : settings) {
      if (value != defaults.at(name)) {
        EXPECT_EQ(page.count(name), 1u) << name << " of paper_" << sensor << ".yaml";
      }
    }
  }
}

TEST(PaperConfig, FilesAndTestsOfThePageExist) {
  const std::string page = TextOf(kSource / "docs/paper.md");
  const std::regex name("`((?:radive|tests|configs)/[^`:]+)(?::([A-Za-z0-9]+)\\.([A-Za-z0-9]+))?`");
  int num_tests = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), name), end; it != end; ++it) {
    const fs::path file = kSource / (*it)[1].str();
    ASSERT_TRUE(fs::exists(file)) << file;
    if (!(*it)[2].matched) continue;
    ++num_tests;
    const std::regex test("TEST(_F|_P)?\\(" + (*it)[2].str() + ", " + (*it)[3].str() + "\\)");
    EXPECT_TRUE(std::regex_search(TextOf(file), test)) << it->str();
  }
  EXPECT_GT(num_tests, 25);
  // Each row of the tables names a test.
  std::istringstream lines(page);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| ---", 0) == 0 ||
        line.rfind("| The paper |", 0) == 0) {
      continue;
    }
    EXPECT_NE(line.find("_test.cc:"), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace radive
