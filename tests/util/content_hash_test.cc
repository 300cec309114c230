// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/content_hash.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::ScratchFolder;
namespace fs = std::filesystem;

void Write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::string Tree(const fs::path& path, std::uintmax_t max_bytes = 1 << 20) {
  std::string error;
  const auto hash = HashTree(path, &error, max_bytes);
  EXPECT_TRUE(hash.has_value()) << error;
  return hash.value_or("");
}

TEST(ContentHash, IsXxh3) {
  // Digest of no bytes, from the specification of XXH3 with 128 bits.
  EXPECT_EQ(HashText(""), "99aa06d3014798d86001c324468d497f");
  ContentHash hash;
  hash.Add("ab");
  hash.Add("c");
  EXPECT_EQ(hash.Hex(), HashText("abc"));
}

TEST(ContentHash, PartsDoNotRunTogether) {
  ContentHash one;
  one.AddPart("ab");
  one.AddPart("c");
  ContentHash two;
  two.AddPart("a");
  two.AddPart("bc");
  EXPECT_NE(one.Hex(), two.Hex());
}

TEST(HashTree, DependsOnNamesAndBytesAlone) {
  const ScratchFolder scratch;
  const fs::path one = scratch.path() / "one";
  const fs::path two = scratch.path() / "two";
  Write(one / "a.bin", "123");
  Write(one / "sub" / "b.bin", "456");
  fs::copy(one, two, fs::copy_options::recursive);
  fs::last_write_time(two / "a.bin", fs::last_write_time(one / "a.bin") - std::chrono::hours(5));
  EXPECT_EQ(Tree(one), Tree(two));
  const std::string before = Tree(two);
  Write(two / "sub" / "b.bin", "457");
  EXPECT_NE(Tree(two), before);
  Write(two / "sub" / "b.bin", "456");
  EXPECT_EQ(Tree(two), before);
  fs::rename(two / "a.bin", two / "c.bin");
  EXPECT_NE(Tree(two), before);
}

TEST(HashTree, OfHugeTreesTakesTheEndsOfFiles) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "big.bin";
  std::string bytes(300000, 'x');
  Write(file, bytes);
  const std::string before = Tree(file, 1000);
  bytes[150000] = 'y';
  Write(file, bytes);
  EXPECT_EQ(Tree(file, 1000), before);
  EXPECT_NE(Tree(file), Tree(file, 1000));
  bytes[299999] = 'y';
  Write(file, bytes);
  EXPECT_NE(Tree(file, 1000), before);
}

TEST(HashTree, NamesWhatCannotBeRead) {
  std::string error;
  EXPECT_FALSE(HashTree("/nowhere/at/all", &error));
  EXPECT_THAT(error, ::testing::HasSubstr("/nowhere/at/all: cannot be read: No such file"));
}

TEST(TreeSignature, SeesNewTimesAndSizes) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "a.bin";
  Write(file, "123");
  const auto before = TreeSignature(scratch.path());
  ASSERT_TRUE(before);
  EXPECT_EQ(TreeSignature(scratch.path()), before);
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1));
  EXPECT_NE(TreeSignature(scratch.path()), before);
  EXPECT_FALSE(TreeSignature("/nowhere"));
}

}  // namespace
}  // namespace radive
