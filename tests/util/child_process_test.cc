// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "radive/util/file_lock.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::ScratchFolder;

std::unique_ptr<ChildProcess> Shell(const std::string& script, int inherited_fd = -1) {
  std::string error;
  auto child = ChildProcess::Start({"/bin/sh", "-c", script}, inherited_fd, &error);
  EXPECT_NE(child, nullptr) << error;
  return child;
}

void WaitFor(ChildProcess* child) {
  for (int i = 0; i < 5000 && !child->HasEnded(); ++i) usleep(2000);
  ASSERT_TRUE(child->HasEnded());
}

TEST(ChildProcess, GivesStatusOutputAndUsage) {
  const auto child = Shell("echo out; echo err >&2; exit 3");
  WaitFor(child.get());
  EXPECT_EQ(child->exit_status(), 3);
  EXPECT_EQ(child->signal(), 0);
  EXPECT_EQ(child->Output(), "out\nerr\n");
  EXPECT_GT(child->peak_memory_mb(), 0.1);
  EXPECT_LT(child->cpu_seconds(), 5.0);
}

TEST(ChildProcess, GivesTheSignalThatEndedIt) {
  const auto child = Shell("kill -SEGV $$");
  WaitFor(child.get());
  EXPECT_EQ(child->exit_status(), -1);
  EXPECT_EQ(child->signal(), SIGSEGV);
}

TEST(ChildProcess, SaysThatAProgramIsMissing) {
  std::string error;
  const auto child = ChildProcess::Start({"/nowhere/program"}, -1, &error);
  ASSERT_NE(child, nullptr);
  WaitFor(child.get());
  EXPECT_EQ(child->exit_status(), 127);
  EXPECT_THAT(child->Output(), HasSubstr("/nowhere/program: cannot be executed: No such file"));
}

TEST(ChildProcess, RunsAFunction) {
  std::string error;
  const auto child = ChildProcess::Start(
      [](std::string* reason) {
        *reason = "too heavy";
        return false;
      },
      -1,
      &error);
  ASSERT_NE(child, nullptr);
  WaitFor(child.get());
  EXPECT_EQ(child->exit_status(), 1);
  EXPECT_EQ(child->Output(), "too heavy\n");
}

TEST(ChildProcess, KeepsTheEndOfALongOutput) {
  const auto child = Shell("head -c 3000000 /dev/zero | tr '\\0' x; echo end");
  WaitFor(child.get());
  const std::string output = child->Output();
  EXPECT_EQ(output.size(), std::size_t{1} << 20);
  EXPECT_EQ(output.substr(output.size() - 5), "xend\n");
}

TEST(FileLock, IsHeldByOneAtATime) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "lock";
  std::string error;
  auto lock = FileLock::Take(file, FileLock::Wait::kNo, &error);
  ASSERT_TRUE(lock) << error;
  EXPECT_FALSE(FileLock::Take(file, FileLock::Wait::kNo, &error));
  EXPECT_EQ(error, "");
  lock.reset();
  EXPECT_TRUE(FileLock::Take(file, FileLock::Wait::kYes, &error));
  EXPECT_FALSE(FileLock::Take("/nowhere/lock", FileLock::Wait::kNo, &error));
  EXPECT_THAT(error, HasSubstr("/nowhere/lock: cannot be locked: No such file"));
}

// A child that was given a lock holds it for as long as it lives; one that was not does not.
TEST(FileLock, LastsAsLongAsTheChildThatInheritsIt) {
  const ScratchFolder scratch;
  std::string error;
  const auto given_file = scratch.path() / "given";
  const auto kept_file = scratch.path() / "kept";
  auto given = FileLock::Take(given_file, FileLock::Wait::kNo, &error);
  auto kept = FileLock::Take(kept_file, FileLock::Wait::kNo, &error);
  ASSERT_TRUE(given && kept);
  const auto child = ChildProcess::Start(
      [](std::string*) {
        sleep(60);
        return true;
      },
      given->fd(),
      &error);
  ASSERT_NE(child, nullptr);
  usleep(50000);  // until the child has closed what it was not given
  given.reset();
  kept.reset();
  EXPECT_FALSE(FileLock::Take(given_file, FileLock::Wait::kNo, &error));
  EXPECT_TRUE(FileLock::Take(kept_file, FileLock::Wait::kYes, &error));
  child->Kill();
  EXPECT_TRUE(FileLock::Take(given_file, FileLock::Wait::kYes, &error));
}

}  // namespace
}  // namespace radive
