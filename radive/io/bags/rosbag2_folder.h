// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/bags/message_source.h"

namespace radive {

// What the metadata.yaml of a rosbag 2 folder says.
struct Rosbag2Metadata {
  bool is_mcap = false;            // storage_identifier; false: sqlite3
  std::vector<std::string> files;  // relative_file_paths, in their order
};

// Reads the text of a metadata.yaml. False, with what is wrong in `error`, for a text that is none,
// another storage than sqlite3 and mcap, or another compression than zstd.
bool ParseRosbag2Metadata(const std::string& text, Rosbag2Metadata* metadata, std::string* error);

// Opens the rosbag 2 folder, whose files are one bag. Files that are packed as a whole are unpacked
// into temporary files.
std::unique_ptr<MessageSource> OpenRosbag2Folder(const std::filesystem::path& folder,
                                                 const MessageLimits& limits,
                                                 std::string* error);

}  // namespace radive
