// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The studies in configs/studies/ are what they say. RADIVE_STUDIES is that folder, from CMake.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "radive/studies/load_study.h"
#include "radive/studies/study_runs.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::ScratchFolder;
namespace fs = std::filesystem;

std::vector<fs::path> ShippedStudies() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(RADIVE_STUDIES)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Study Load(const fs::path& file, const fs::path& data_root) {
  std::string error;
  const auto study = LoadStudy(file, {data_root, {}}, &error);
  EXPECT_TRUE(study.has_value()) << error;
  return study.value_or(Study());
}

TEST(ShippedStudies, CanBeRun) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "my_drive");  // that the glob of my_drives.yaml finds
  ASSERT_EQ(ShippedStudies().size(), 13u);
  for (const fs::path& file : ShippedStudies()) {
    const Study study = Load(file, scratch.path());
    std::string error;
    const auto runs = ListRuns(study, &error);
    ASSERT_TRUE(runs) << error;
    EXPECT_GE(runs->size(), study.sequences.size()) << file;
    // A variant that changes nothing is a mistake.
    std::set<std::string> hashes;
    for (const StudyRun& run : *runs) {
      if (run.sequence == &study.sequences[0] && run.seed == study.seeds[0]) {
        EXPECT_TRUE(hashes.insert(ConfigHash(study, run)).second) << file << " " << run.Name();
      }
    }
  }
}

TEST(ShippedStudies, PublishedFiguresAreOfTheirSequences) {
  int num_tables = 0;
  for (const fs::path& file : ShippedStudies()) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "my_drive");
    const Study study = Load(file, scratch.path());
    if (study.published.empty()) continue;
    ++num_tables;
    std::set<std::string> names;
    for (const StudySequence& sequence : study.sequences) names.insert(sequence.name);
    std::ifstream table(study.published);
    std::string line;
    ASSERT_TRUE(std::getline(table, line)) << study.published;
    EXPECT_EQ(line.rfind("sequence,method,", 0), 0u) << study.published;
    std::set<std::string> found;
    while (std::getline(table, line)) found.insert(line.substr(0, line.find(',')));
    EXPECT_EQ(found, names) << study.published;
  }
  EXPECT_EQ(num_tables, 5);
}

// Every drive of a table of the paper, of sensors that it has, is there once as we do it and once
// as the paper does.
TEST(ShippedStudies, PaperTablesHaveBothBases) {
  int num_pairs = 0;
  for (const fs::path& file : ShippedStudies()) {
    if (file.stem().string().rfind("paper_", 0) != 0) continue;
    const ScratchFolder scratch;
    const Study study = Load(file, scratch.path());
    std::map<std::string, std::string> configs;
    for (const StudySequence& sequence : study.sequences) {
      configs[sequence.name] = fs::path(sequence.config).stem().string();
    }
    for (const auto& [name, config] : configs) {
      const std::string suffix = "_paper";
      const bool is_paper = config == "paper_dense" || config == "paper_sparse";
      const bool has_suffix = name.size() > suffix.size() &&
                              name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
      EXPECT_EQ(is_paper, has_suffix) << file << " " << name;
      if (is_paper || config == "radarscenes") continue;
      EXPECT_EQ(configs.count(name + suffix), 1u) << file << " " << name;
      ++num_pairs;
    }
  }
  EXPECT_GT(num_pairs, 40);
}

}  // namespace
}  // namespace radive
