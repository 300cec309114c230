// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/open_message_source.h"

#include <system_error>
#include <utility>
#include <vector>

#include "radive/io/bags/merged_message_source.h"
#include "radive/io/bags/rosbag2_folder.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// The forms that a folder may have, the first that is there.
std::vector<std::pair<BagFormat, std::string>> FormsInFolder(BagFormat format) {
  if (format == BagFormat::kRosbag1) return {{format, "*.bag"}};
  if (format == BagFormat::kMcap) return {{format, "*.mcap"}};
  return {{format, "*.db3"}, {BagFormat::kMcap, "*.mcap"}};
}

std::unique_ptr<MessageSource> OpenFolder(const fs::path& folder,
                                          BagFormat format,
                                          const MessageLimits& limits,
                                          std::string* error) {
  std::vector<fs::path> files;
  std::string expected;
  for (const auto& [form, names] : FormsInFolder(format)) {
    if (files.empty() && !ListBagFiles(folder, form, &files, error)) return nullptr;
    expected += (expected.empty() ? "" : " or ") + names;
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
  // A recorder that was cut off leaves an empty one.
  if (format != BagFormat::kRosbag1 && fs::exists(folder / "metadata.yaml", failure) &&
      (is_metadata || !fs::is_empty(folder / "metadata.yaml", failure))) {
    return OpenRosbag2Folder(folder, limits, error);
  }
  return OpenFolder(folder, format, limits, error);
}

}  // namespace radive
