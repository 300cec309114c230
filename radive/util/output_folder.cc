// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/output_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "radive/util/durable_files.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// Stages of a replacement within the folder. The name says how far it has come, so that it can be
// finished: nothing was touched; the new content is whole; what it does not replace is removed.
constexpr const char* kNew = ".radive-new";
constexpr const char* kReady = ".radive-ready";
constexpr const char* kMoving = ".radive-moving";

bool IsStage(const std::string& name) { return name == kNew || name == kReady || name == kMoving; }

std::vector<std::string> Names(const fs::path& folder, std::error_code* code) {
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, *code);
  for (; !*code && entry != fs::directory_iterator(); entry.increment(*code)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());  // messages and order are always the same
  return names;
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// True, or sets `error`.
bool Check(const std::error_code& code,
           const fs::path& path,
           const char* what,
           std::string* error) {
  if (code) *error = path.string() + ": " + what + ": " + SystemMessage(code);
  return !code;
}

bool IsWithin(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

bool IsMountPoint(const fs::path& folder) {
  struct statx status = {};
  return statx(AT_FDCWD, folder.c_str(), 0, STATX_TYPE, &status) == 0 &&
         (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

}  // namespace

fs::path OutputFolder::StagedBeside(const fs::path& folder) {
  return folder.parent_path() / ("." + folder.filename().string() + ".radive");
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!staged_.empty()) fs::remove_all(staged_, ignored);
  // Empty folders that nothing came into; remove() leaves others alone.
  fs::path folder = folder_;
  for (; lock_ && num_made_ > 0; --num_made_, folder = folder.parent_path()) {
    if (!fs::remove(folder, ignored)) break;
  }
}

bool OutputFolder::Open(const fs::path& folder, IsOwn is_own, std::string* error) {
  is_own_ = std::move(is_own);
  std::error_code code;
  if (fs::exists(folder, code) && !fs::is_directory(folder, code)) {
    *error = folder.string() + ": the output must be a folder, is a file";
    return false;
  }
  int num_made = 0;
  for (fs::path path = fs::absolute(folder, code).lexically_normal();
       !path.empty() && path != path.root_path() && !Exists(path);
       path = path.parent_path()) {
    if (path.has_filename()) ++num_made;
  }
  fs::create_directories(folder, code);
  if (!Check(code, folder, "cannot create the output folder", error)) return false;
  folder_ = fs::canonical(folder, code);
  if (!Check(code, folder, "cannot be resolved", error)) return false;
  lock_ = FileLock::TakeFolder(folder_, error);
  if (!lock_) {
    if (error->empty()) {
      *error = folder.string() + ": another program is writing into this folder";
    }
    return false;
  }
  num_made_ = num_made;
  return RefuseStrangers(folder, error) && Recover(error);
}

bool OutputFolder::RefuseStrangers(const fs::path& folder, std::string* error) const {
  std::error_code code;
  for (const std::string& name : Names(folder_, &code)) {
    if (IsOurs(name) || IsStage(name)) continue;
    *error = folder.string() + ": the output folder must be new" +
             (is_own_ ? ", empty or hold earlier results only" : " or empty") + "; it holds " +
             name;
    return false;
  }
  return Check(code, folder, "cannot list the output folder", error);
}

// Clears away what a killed program has left, and finishes what it had begun to replace.
bool OutputFolder::Recover(std::string* error) {
  staged_ = StagedBeside(folder_);
  RemoveEarlier();
  std::error_code code;
  fs::remove_all(folder_ / kNew, code);
  return ReplaceEach(error);
}

bool OutputFolder::IsOurs(const std::string& name) const { return is_own_ && is_own_(name); }

bool OutputFolder::CanBeExchanged() const {
  std::error_code code;
  const fs::path current = fs::current_path(code);
  return folder_.has_filename() && !IsWithin(current, folder_) && !IsMountPoint(folder_) &&
         access(folder_.parent_path().c_str(), W_OK) == 0;
}

bool OutputFolder::Stage(std::string* error) {
  std::error_code code;
  staged_ = StagedBeside(folder_);
  if (CanBeExchanged() && fs::create_directory(staged_, code)) {
    // It is to take the place of the folder, so it must belong to the same user.
    struct stat earlier = {};
    if (stat(folder_.c_str(), &earlier) == 0 &&
        chown(staged_.c_str(), earlier.st_uid, earlier.st_gid) == 0 &&
        chmod(staged_.c_str(), earlier.st_mode & 07777) == 0) {
      return true;
    }
    fs::remove(staged_, code);
  }
  staged_ = folder_ / kNew;
  fs::create_directory(staged_, code);
  return Check(code, staged_, "cannot be made", error);
}

bool OutputFolder::Publish(std::string* error) {
  if (!SyncTree(staged_, error)) return false;
  if (staged_ != folder_ / kNew) {
    std::optional<FileLock> lock = FileLock::TakeFolder(staged_, error);
    if (!lock) return false;
    if (LinkStrangers() && ExchangeFolders(staged_, folder_)) {
      lock_ = std::move(lock);
      const bool is_synced = SyncAncestors(error);
      RemoveEarlier();
      return is_synced;
    }
    std::error_code code;
    for (const std::string& name : Names(folder_, &code)) {  // linked in vain
      if (!IsOurs(name) && !IsStage(name)) fs::remove(staged_ / name, code);
    }
    fs::rename(staged_, folder_ / kNew, code);
    if (!Check(code, folder_, "cannot be written", error)) return false;
    staged_ = folder_ / kNew;
  }
  std::error_code code;
  fs::rename(staged_, folder_ / kReady, code);
  if (!Check(code, folder_, "cannot be written", error)) return false;
  staged_.clear();
  return SyncPath(folder_, error) && ReplaceEach(error) && SyncAncestors(error);
}

// Into the staged folder, under a second name. False when one is a folder, or has to stay.
bool OutputFolder::LinkStrangers() const {
  std::error_code code;
  for (const std::string& name : Names(folder_, &code)) {
    if (IsOurs(name) || IsStage(name)) continue;
    if (link((folder_ / name).c_str(), (staged_ / name).c_str()) != 0) return false;
  }
  std::string ignored;
  return !code && SyncPath(staged_, &ignored);
}

// The folder beside: earlier content after an exchange, new content before it.
void OutputFolder::RemoveEarlier() {
  std::error_code code;
  for (const std::string& name : Names(staged_, &code)) {
    // Of another program, and came in the moment of the exchange.
    if (!IsOurs(name) && !IsStage(name) && !Exists(folder_ / name)) {
      fs::rename(staged_ / name, folder_ / name, code);
    }
  }
  fs::remove_all(staged_, code);
  staged_.clear();
}

// From kReady on.
bool OutputFolder::ReplaceEach(std::string* error) {
  std::error_code code;
  const fs::path ready = folder_ / kReady;
  if (Exists(ready)) {
    for (const std::string& name : Names(folder_, &code)) {
      if (IsOurs(name) && !Exists(ready / name)) fs::remove_all(folder_ / name, code);
    }
    fs::rename(ready, folder_ / kMoving, code);
    if (!Check(code, folder_, "cannot be written", error)) return false;
  }
  return !Exists(folder_ / kMoving) || MoveEach(error);
}

bool OutputFolder::MoveEach(std::string* error) const {
  std::error_code code;
  const fs::path moving = folder_ / kMoving;
  for (const std::string& name : Names(moving, &code)) {
    if (fs::is_directory(folder_ / name, code)) fs::remove_all(folder_ / name, code);
    fs::rename(moving / name, folder_ / name, code);
    if (!Check(code, folder_ / name, "cannot be written", error)) return false;
  }
  fs::remove_all(moving, code);
  return SyncPath(folder_, error);
}

bool OutputFolder::SyncAncestors(std::string* error) const {
  fs::path folder = folder_.parent_path();
  for (int i = 0; i <= num_made_; ++i, folder = folder.parent_path()) {
    if (!SyncPath(folder, error)) return false;
  }
  return true;
}

}  // namespace radive
