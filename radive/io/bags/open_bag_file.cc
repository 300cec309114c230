// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/open_bag_file.h"

#include <algorithm>
#include <utility>

#include "radive/io/bags/mcap_reader.h"
#include "radive/io/bags/ros1_bag_reader.h"
#include "radive/io/bags/sqlite_bag_reader.h"
#include "radive/io/bags/unpacking_message_source.h"
#include "radive/io/bytes/random_access_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/bytes/unpacked_file.h"
#include "radive/io/scans/scan_folder.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// Takes `end` off the end of `text`, if it is there.
bool TakeEnd(std::string_view end, std::string_view* text) {
  if (text->size() <= end.size() || text->substr(text->size() - end.size()) != end) return false;
  text->remove_suffix(end.size());
  return true;
}

// The name that the file has, or will have, when it is closed and unpacked. Takes lower case.
std::string_view FinalName(std::string_view name) {
  if (!TakeEnd(".zstd", &name) && !TakeEnd(".zst", &name)) TakeEnd(".active", &name);
  return name;
}

std::string WhyNoBag(std::string_view start) {
  if (start.empty()) return "; it is empty";
  if (start.substr(0, 2) == "\x1F\x8B") return "; it is packed with gzip, unpack it first";
  if (start.substr(0, 3) == "BZh") return "; it is packed with bzip2, unpack it first";
  if (start.substr(0, 4) == "PK\x03\x04") return "; it is a zip archive, unpack it first";
  return "";
}

// Null when the disk did not give the bytes that opening looked for: what was found is not all.
std::unique_ptr<MessageSource> OpenedWhole(std::unique_ptr<ChunkedBagReader> reader,
                                           std::string* error) {
  if (reader == nullptr || reader->read_error().empty()) return reader;
  *error = reader->read_error();
  return nullptr;
}

// The file at `plain`; messages call it `name`.
std::unique_ptr<MessageSource> OpenPlain(const fs::path& plain,
                                         const std::string& name,
                                         const MessageLimits& limits,
                                         std::string* error) {
  std::unique_ptr<RandomAccessFile> file = OpenRandomAccessFile(plain, error, name);
  if (file == nullptr) return nullptr;
  std::string buffer;
  const auto start = file->Read(0, std::min<std::uint64_t>(16, file->size()), &buffer);
  const auto starts_with = [&](std::string_view magic) {
    return start && start->substr(0, magic.size()) == magic;
  };
  const auto unpacking = [&](std::unique_ptr<MessageSource> source) {
    if (source == nullptr) return source;
    return std::unique_ptr<MessageSource>(new UnpackingMessageSource(std::move(source), limits));
  };
  if (starts_with("#ROSBAG")) {
    return OpenedWhole(Ros1BagReader::Open(std::move(file), limits, error), error);
  }
  if (starts_with("\x89MCAP")) {
    return unpacking(OpenedWhole(McapReader::Open(std::move(file), limits, error), error));
  }
  if (starts_with("SQLite format 3")) {
    return unpacking(SqliteBagReader::Open(plain, name, limits, error));
  }
  if (!file->read_error().empty()) {
    *error = name + ": " + file->read_error();
    return nullptr;
  }
  *error = name + ": neither a ROS 1 bag nor the SQLite or MCAP file of a rosbag 2" +
           WhyNoBag(start.value_or(std::string_view()));
  return nullptr;
}

bool IsZstd(const fs::path& path) {
  std::string ignored;
  std::string buffer;
  const std::unique_ptr<RandomAccessFile> file = OpenRandomAccessFile(path, &ignored);
  if (file == nullptr || file->size() < 4) return false;
  const auto start = file->Read(0, 4, &buffer);
  return start && *start == "\x28\xB5\x2F\xFD";
}

}  // namespace

std::optional<BagFormat> BagFormatOfName(std::string_view name) {
  const std::string lower_case = LowerCase(name);
  std::string_view final_name = FinalName(lower_case);
  if (TakeEnd(".bag", &final_name)) return BagFormat::kRosbag1;
  if (TakeEnd(".db3", &final_name)) return BagFormat::kRosbag2;
  if (TakeEnd(".mcap", &final_name)) return BagFormat::kMcap;
  return std::nullopt;
}

bool ListBagFiles(const fs::path& folder,
                  BagFormat format,
                  std::vector<fs::path>* files,
                  std::string* error) {
  files->clear();
  std::vector<std::string> names;
  if (!ListFiles(folder, "", &names, error)) return false;
  std::vector<std::string> lower_case;
  for (const std::string& name : names) lower_case.push_back(LowerCase(name));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (BagFormatOfName(names[i]) != format) continue;
    const std::string_view final_name = FinalName(lower_case[i]);
    const bool is_there_already =
        final_name != lower_case[i] &&
        std::find(lower_case.begin(), lower_case.end(), final_name) != lower_case.end();
    if (!is_there_already) files->push_back(folder / names[i]);
  }
  return true;
}

std::unique_ptr<MessageSource> OpenBagFile(const fs::path& path,
                                           const MessageLimits& limits,
                                           std::string* error) {
  if (!IsZstd(path)) return OpenPlain(path, path.string(), limits, error);
  const std::unique_ptr<UnpackedFile> unpacked = UnpackedFile::OfZstd(path, error);
  if (unpacked == nullptr) return nullptr;
  return OpenPlain(unpacked->path(), path.string(), limits, error);
}

}  // namespace radive
