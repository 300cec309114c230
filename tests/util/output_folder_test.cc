// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/output_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>

#include "tests/scratch_folder.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
using testing::ReadFile;
using testing::ScratchFolder;

bool IsOwn(const std::string& name) { return name == "a" || name == "b" || name == "figures"; }

void WriteInto(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

std::set<std::string> Names(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

class OutputFolderTest : public ::testing::Test {
 protected:
  // An earlier content of a and b, and a new one of a and figures/.
  void Update(const std::function<void()>& before_publish = {}) {
    WriteInto(folder_ / "a", "old");
    WriteInto(folder_ / "b", "old");
    OutputFolder output;
    ASSERT_TRUE(output.Open(folder_, IsOwn, &error_) && output.Stage(&error_)) << error_;
    WriteInto(output.staged() / "a", "new");
    WriteInto(output.staged() / "figures" / "c", "new");
    EXPECT_EQ(ReadFile(folder_ / "a"), "old");
    if (before_publish) before_publish();
    ASSERT_TRUE(output.Publish(&error_)) << error_;
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path() / "out";
  std::string error_;
};

TEST_F(OutputFolderTest, TheNewContentTakesThePlaceOfTheEarlier) {
  Update();
  EXPECT_EQ(Names(folder_), (std::set<std::string>{"a", "figures"}));
  EXPECT_EQ(ReadFile(folder_ / "a"), "new");
  EXPECT_EQ(Names(scratch_.path()), (std::set<std::string>{"out"}));
}

// Renamed one after the other: the process stands in the folder, so it cannot be exchanged.
TEST_F(OutputFolderTest, TheCurrentFolderIsUpdatedInItsPlace) {
  const fs::path before = fs::current_path();
  fs::create_directories(folder_);
  fs::current_path(folder_);
  Update();
  EXPECT_EQ(Names("."), (std::set<std::string>{"a", "figures"}));
  EXPECT_EQ(ReadFile("a"), "new");
  fs::current_path(before);
}

TEST_F(OutputFolderTest, FilesOfOthersThatComeMeanwhileStay) {
  Update([this] { WriteInto(folder_ / "log.txt", "mine"); });
  EXPECT_EQ(ReadFile(folder_ / "log.txt"), "mine");
  EXPECT_EQ(ReadFile(folder_ / "a"), "new");
}

TEST_F(OutputFolderTest, FoldersOfOthersThatComeMeanwhileStay) {
  Update([this] { WriteInto(folder_ / "notes" / "log.txt", "mine"); });
  EXPECT_EQ(ReadFile(folder_ / "notes" / "log.txt"), "mine");
  EXPECT_EQ(ReadFile(folder_ / "a"), "new");
  EXPECT_FALSE(fs::exists(folder_ / "b"));
}

TEST_F(OutputFolderTest, ALinkStaysALink) {
  fs::create_directories(scratch_.path() / "elsewhere" / "real");
  fs::create_directory_symlink(scratch_.path() / "elsewhere" / "real", folder_);
  Update();
  EXPECT_TRUE(fs::is_symlink(folder_));
  EXPECT_EQ(ReadFile(scratch_.path() / "elsewhere" / "real" / "a"), "new");
}

TEST_F(OutputFolderTest, WithoutPublishingNothingHasHappened) {
  {
    OutputFolder output;
    ASSERT_TRUE(output.Open(folder_ / "x" / "y", IsOwn, &error_) && output.Stage(&error_));
    WriteInto(output.staged() / "a", "new");
  }
  EXPECT_TRUE(Names(scratch_.path()).empty());
}

TEST_F(OutputFolderTest, OneProgramAtATime) {
  OutputFolder first;
  ASSERT_TRUE(first.Open(folder_, IsOwn, &error_)) << error_;
  EXPECT_FALSE(OutputFolder().Open(folder_, IsOwn, &error_));
  EXPECT_EQ(error_, folder_.string() + ": another program is writing into this folder");
}

TEST_F(OutputFolderTest, FoldersWithFilesOfOthersAreLeftAlone) {
  WriteInto(folder_ / "thesis.tex", "years of work");
  EXPECT_FALSE(OutputFolder().Open(folder_, IsOwn, &error_));
  EXPECT_NE(error_.find("it holds thesis.tex"), std::string::npos) << error_;
  EXPECT_EQ(ReadFile(folder_ / "thesis.tex"), "years of work");
}

// What kills leave: before the exchange, after it, and at three moments of an update in place.
TEST_F(OutputFolderTest, OpenClearsUpAfterAKill) {
  const auto open = [this] { return OutputFolder().Open(folder_, IsOwn, &error_); };
  WriteInto(folder_ / "a", "whole");
  WriteInto(OutputFolder::StagedBeside(folder_) / "a", "other");
  WriteInto(OutputFolder::StagedBeside(folder_) / "log.txt", "mine");
  ASSERT_TRUE(open()) << error_;
  EXPECT_EQ(ReadFile(folder_ / "a"), "whole");
  EXPECT_EQ(ReadFile(folder_ / "log.txt"), "mine");
  EXPECT_EQ(Names(scratch_.path()), (std::set<std::string>{"out"}));

  fs::remove(folder_ / "log.txt");
  WriteInto(folder_ / ".radive-new" / "a", "half");
  ASSERT_TRUE(open()) << error_;
  EXPECT_EQ(ReadFile(folder_ / "a"), "whole");
  WriteInto(folder_ / "b", "whole");
  WriteInto(folder_ / ".radive-ready" / "a", "new");
  ASSERT_TRUE(open()) << error_;
  EXPECT_EQ(ReadFile(folder_ / "a"), "new");
  WriteInto(folder_ / ".radive-moving" / "b", "newer");
  ASSERT_TRUE(open()) << error_;
  EXPECT_EQ(Names(folder_), (std::set<std::string>{"a", "b"}));
  EXPECT_EQ(ReadFile(folder_ / "b"), "newer");
}

}  // namespace
}  // namespace radive
