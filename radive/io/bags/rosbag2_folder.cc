// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/rosbag2_folder.h"

#include <yaml-cpp/yaml.h>

#include <system_error>
#include <utility>

#include "radive/io/bags/merged_message_source.h"
#include "radive/io/bags/open_bag_file.h"
#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

std::string TextOr(const YAML::Node& node, const std::string& otherwise) {
  return node.IsDefined() && node.IsScalar() ? node.Scalar() : otherwise;
}

// Packed files and messages are known by what they are; here only what cannot be unpacked is told.
bool CheckCompression(const YAML::Node& information, std::string* error) {
  const std::string mode = LowerCase(TextOr(information["compression_mode"], ""));
  const std::string format = LowerCase(TextOr(information["compression_format"], ""));
  if (mode.empty() || mode == "none" || format.empty()) return true;
  if (format == "zstd" && (mode == "file" || mode == "message")) return true;
  *error = "compression " + Quoted(format) + " of " + Quoted(mode) +
           ", expected zstd of file or message";
  return false;
}

bool ParseInformation(const YAML::Node& root, Rosbag2Metadata* metadata, std::string* error) {
  const YAML::Node information = root.IsMap() ? root["rosbag2_bagfile_information"] : YAML::Node();
  if (!information.IsDefined() || !information.IsMap()) {
    *error = "no rosbag2_bagfile_information, expected the metadata.yaml of a rosbag 2";
    return false;
  }
  const std::string storage = TextOr(information["storage_identifier"], "");
  metadata->is_mcap = storage == "mcap";
  if (!metadata->is_mcap && storage != "sqlite3") {
    *error = "storage_identifier " + Quoted(storage) + ", expected sqlite3 or mcap";
    return false;
  }
  const YAML::Node files = information["relative_file_paths"];
  if (files.IsDefined() && files.IsSequence()) {
    for (const YAML::Node& file : files) metadata->files.push_back(TextOr(file, ""));
  }
  if (metadata->files.empty()) {
    *error = "no relative_file_paths, expected the names of the bag's files";
    return false;
  }
  return CheckCompression(information, error);
}

// The file that metadata.yaml calls `name`. Early releases wrote the name of the folder in front,
// and files that are packed may have been unpacked by hand.
fs::path FindFile(const fs::path& folder, const std::string& name) {
  const fs::path given = fs::path(name);
  fs::path found = folder / given.filename();
  std::error_code ignored;
  if (!fs::exists(found, ignored) && given.is_relative() && fs::exists(folder / given, ignored)) {
    found = folder / given;
  }
  if (!fs::exists(found, ignored)) {
    for (const fs::path& other :
         {fs::path(found.string() + ".zstd"), fs::path(found).replace_extension()}) {
      if (fs::exists(other, ignored) && other.has_extension()) return other;
    }
  }
  return found;
}

}  // namespace

bool ParseRosbag2Metadata(const std::string& text, Rosbag2Metadata* metadata, std::string* error) {
  *metadata = {};
  try {
    return ParseInformation(YAML::Load(text), metadata, error);
  } catch (const YAML::Exception& exception) {
    *error = exception.what();
    return false;
  }
}

std::unique_ptr<MessageSource> OpenRosbag2Folder(const fs::path& folder,
                                                 const MessageLimits& limits,
                                                 std::string* error) {
  const fs::path metadata_file = folder / "metadata.yaml";
  std::string text;
  if (!ReadWholeFile(metadata_file, &text, error)) return nullptr;
  Rosbag2Metadata metadata;
  std::string reason;
  if (!ParseRosbag2Metadata(text, &metadata, &reason)) {
    *error = metadata_file.string() + ": " + reason;
    return nullptr;
  }
  std::vector<std::unique_ptr<MessageSource>> parts;
  for (const std::string& name : metadata.files) {
    parts.push_back(OpenBagFile(FindFile(folder, name), limits, error));
    if (parts.back() == nullptr) return nullptr;
  }
  const std::string description = "rosbag 2 folder " + folder.string() + ", " +
                                  std::to_string(parts.size()) +
                                  (metadata.is_mcap ? " MCAP files" : " SQLite files");
  return std::make_unique<MergedMessageSource>(std::move(parts), description);
}

}  // namespace radive
