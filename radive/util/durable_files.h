// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

namespace radive {

// What must outlast a power cut is synced in this order, as SQLite does it: the bytes of a file,
// the folder that names it, then the rename that publishes it, then the folder of the rename.

// A file, or the names in a folder, are on the disk when this returns true. Otherwise `error` names
// the path and the reason. File systems that cannot sync folders are taken at their word.
bool SyncPath(const std::filesystem::path& path, std::string* error);

// The same of a folder with everything below it.
bool SyncTree(const std::filesystem::path& folder, std::string* error);

// Exchanges two folders of the same file system in one step: whoever looks sees the one or the
// other. False, with errno set, where the file system or a mount point forbids it.
bool ExchangeFolders(const std::filesystem::path& a, const std::filesystem::path& b);

// Puts the folder `made` at the place of `folder`, which may exist, in one step that outlasts a
// power cut; what was there is removed afterwards. Both are in the same parent folder.
bool ReplaceFolder(const std::filesystem::path& made,
                   const std::filesystem::path& folder,
                   std::string* error);

}  // namespace radive
