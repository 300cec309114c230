// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "radive/util/file_lock.h"

namespace radive {

// The folder of a program's results, which others read by fixed names. It changes from its earlier
// content to the new one in one step: whoever looks, also after a kill or a power cut, finds either
// of them whole. One program at a time has it.
//
//   OutputFolder output;
//   output.Open("results", IsResultFile, &error) && output.Stage(&error);
//   ... write files into output.staged() ...
//   output.Publish(&error)
//
// The new content is written into a folder beside, .NAME.radive, which is exchanged with the old
// one. Where that cannot be (NAME is a mount point or the current folder, its parent is read-only,
// the file system knows no exchange), the new content is written below NAME and its files are
// renamed one after the other; Open() finishes that when it was broken off. docs/reliability.md has
// more.
class OutputFolder {
 public:
  // Whether an entry of the folder is the program's own, and may be replaced; null: none is.
  using IsOwn = std::function<bool(const std::string& name)>;

  OutputFolder() = default;
  ~OutputFolder();  // removes what was staged and not published
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Makes the folder when it is missing and locks it. False, with the reason, when another program
  // has it, or when it holds an entry that is not the program's own.
  bool Open(const std::filesystem::path& folder, IsOwn is_own, std::string* error);

  // Makes the empty folder for the new content.
  bool Stage(std::string* error);

  const std::filesystem::path& staged() const { return staged_; }

  // Replaces the program's own entries by those that were staged. Entries of others that have come
  // in the meantime stay. False when it could not; the earlier content is whole then.
  bool Publish(std::string* error);

  // Where Stage() writes for `folder`: what is there when no program runs was left by a kill.
  static std::filesystem::path StagedBeside(const std::filesystem::path& folder);

 private:
  bool Recover(std::string* error);
  bool RefuseStrangers(const std::filesystem::path& folder, std::string* error) const;
  bool IsOurs(const std::string& name) const;
  bool CanBeExchanged() const;
  bool LinkStrangers() const;
  void RemoveEarlier();
  bool ReplaceEach(std::string* error);
  bool MoveEach(std::string* error) const;
  bool SyncAncestors(std::string* error) const;

  std::filesystem::path folder_;  // resolved
  IsOwn is_own_;
  std::optional<FileLock> lock_;
  std::filesystem::path staged_;  // empty when nothing is staged
  int num_made_ = 0;              // folders that Open() made: this one and ancestors
};

}  // namespace radive
