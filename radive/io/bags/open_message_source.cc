// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/open_message_source.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "radive/io/bags/mcap_reader.h"
#include "radive/io/bags/merged_message_source.h"
#include "radive/io/bags/ros1_bag_reader.h"
#include "radive/io/bags/rosbag2_folder.h"
#include "radive/io/bags/sqlite_bag_reader.h"
#include "radive/io/bags/unpacking_message_source.h"
#include "radive/io/bytes/random_access_file.h"
#include "radive/io/bytes/record_file.h"
#include "radive/util/natural_order.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<MessageSource> OpenBagFile(const fs::path& path,
                                           const MessageLimits& limits,
                                           std::string* error) {
  std::unique_ptr<RandomAccessFile> file = OpenRandomAccessFile(path, error);
  if (file == nullptr) return nullptr;
  std::string buffer;
  const auto start = file->Read(0, std::min<std::uint64_t>(16, file->size()), &buffer);
  const auto starts_with = [&](std::string_view magic) {
    return start && start->substr(0, magic.size()) == magic;
  };
  const auto unpacked = [&](std::unique_ptr<MessageSource> source) {
    if (source == nullptr) return source;
    return std::unique_ptr<MessageSource>(new UnpackingMessageSource(std::move(source), limits));
  };
  if (starts_with("#ROSBAG")) return Ros1BagReader::Open(std::move(file), limits, error);
  if (starts_with("\x89MCAP")) return unpacked(McapReader::Open(std::move(file), limits, error));
  if (starts_with("SQLite format 3")) {
    return unpacked(SqliteBagReader::Open(path, path.string(), limits, error));
  }
  *error = path.string() + ": neither a ROS 1 bag nor the SQLite or MCAP file of a rosbag 2" +
           (file->size() == 0 ? "; it is empty" : "");
  return nullptr;
}

// Files in `folder` with the extension, in the order of their names. False when it cannot be
// listed.
bool ListFiles(const fs::path& folder,
               std::string_view extension,
               std::vector<fs::path>* files,
               std::string* error) {
  std::error_code failure;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    std::error_code ignored;
    if (it->path().extension() == extension && !it->is_directory(ignored)) {
      files->push_back(it->path());
    }
  }
  if (failure) *error = folder.string() + ": cannot be listed: " + failure.message();
  std::sort(files->begin(), files->end(), [](const fs::path& a, const fs::path& b) {
    return NaturalLess(a.filename().string(), b.filename().string());
  });
  return !failure;
}

std::vector<std::string_view> Extensions(BagFormat format) {
  switch (format) {
    case BagFormat::kRosbag1:
      return {".bag"};
    case BagFormat::kRosbag2:
      return {".db3", ".mcap"};
    case BagFormat::kMcap:
      return {".mcap"};
  }
  return {};
}

std::unique_ptr<MessageSource> OpenFolder(const fs::path& folder,
                                          BagFormat format,
                                          const MessageLimits& limits,
                                          std::string* error) {
  std::vector<fs::path> files;
  std::string expected;
  for (const std::string_view extension : Extensions(format)) {
    if (files.empty() && !ListFiles(folder, extension, &files, error)) return nullptr;
    expected += (expected.empty() ? "*" : " or *") + std::string(extension);
  }
  if (files.empty()) {
    *error = folder.string() + ": expected a bag, or a folder with " + expected + " files" +
             (format == BagFormat::kRosbag2 ? " or a metadata.yaml" : "") + "; it has none";
    return nullptr;
  }
  std::vector<std::unique_ptr<MessageSource>> parts;
  for (const fs::path& file : files) {
    parts.push_back(OpenBagFile(file, limits, error));
    if (parts.back() == nullptr) return nullptr;
  }
  const std::string description = std::to_string(files.size()) + " bag files in " + folder.string();
  return std::make_unique<MergedMessageSource>(std::move(parts), description);
}

}  // namespace

std::unique_ptr<MessageSource> OpenMessageSource(const fs::path& path,
                                                 BagFormat format,
                                                 const MessageLimits& limits,
                                                 std::string* error) {
  std::error_code failure;
  if (!fs::exists(path, failure)) {
    *error = path.string() + ": expected a bag, but it does not exist";
    return nullptr;
  }
  const bool is_metadata = path.filename() == "metadata.yaml";
  if (!fs::is_directory(path, failure) && !is_metadata) return OpenBagFile(path, limits, error);
  const fs::path folder = is_metadata ? path.parent_path() : path;
  if (format != BagFormat::kRosbag1 && fs::exists(folder / "metadata.yaml", failure)) {
    return OpenRosbag2Folder(folder, limits, error);
  }
  return OpenFolder(folder, format, limits, error);
}

}  // namespace radive
