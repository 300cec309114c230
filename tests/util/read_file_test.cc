// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::ScratchFolder;

std::string ReasonOf(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  std::string bytes = "before", reason;
  EXPECT_FALSE(ReadFileBytes(path, max_bytes, &bytes, &reason));
  EXPECT_EQ(bytes, "");
  return reason;
}

TEST(ReadFileBytes, ReadsFilesUpToTheBound) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "file";
  for (const std::size_t size : {0, 1, 65535, 65536, 300000}) {
    const std::string content(size, 'x');
    std::ofstream(file, std::ios::binary) << content;
    std::string bytes, reason;
    ASSERT_TRUE(ReadFileBytes(file, size, &bytes, &reason)) << reason;
    EXPECT_EQ(bytes, content);
    if (size > 0) {
      EXPECT_EQ(ReasonOf(file, size - 1), "larger than " + std::to_string(size - 1) + " bytes");
    }
  }
}

TEST(ReadFileBytes, RefusesALargeFileUnread) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "file";
  std::ofstream(file).close();
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // takes no space
  EXPECT_EQ(ReasonOf(file, 1000), "larger than 1000 bytes");
}

TEST(ReadFileBytes, EndsWithWhatNeverEnds) {
  EXPECT_EQ(ReasonOf("/dev/zero", 100000), "larger than 100000 bytes");
  EXPECT_EQ(ReasonOf("/", 1000), "is a folder");
  EXPECT_EQ(ReasonOf("/nonexistent", 1000), "No such file or directory");
}

TEST(ReadFileBytes, ReadsAPipe) {
  const ScratchFolder scratch;
  const std::filesystem::path pipe = scratch.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string content(200000, 'y');
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << content; });
  std::string bytes, reason;
  EXPECT_TRUE(ReadFileBytes(pipe, 1000000, &bytes, &reason)) << reason;
  writer.join();
  EXPECT_EQ(bytes, content);
}

}  // namespace
}  // namespace radive
