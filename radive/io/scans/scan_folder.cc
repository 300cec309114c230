// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/scan_folder.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/scans/scan_stamps.h"
#include "radive/util/natural_order.h"
#include "radive/util/number_text.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestSearch = 6;

std::string_view Stem(std::string_view name) { return name.substr(0, name.rfind('.')); }

bool IsDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

// As ListFiles(), but only names that can be scans of the drive.
bool ListScans(const fs::path& folder,
               const ScanFolderQuery& query,
               std::vector<std::string>* names,
               std::string* error) {
  if (!ListFiles(folder, query.extension, names, error)) return false;
  if (!query.names_are_stamps) return true;
  names->erase(std::remove_if(names->begin(),
                              names->end(),
                              [](const std::string& name) { return !IsDigits(Stem(name)); }),
               names->end());
  return true;
}

// Folders below `root` whose path ends in `name`, sorted.
std::vector<fs::path> FoldersBelow(const fs::path& root, const std::string& name) {
  std::vector<fs::path> found;
  std::error_code failure;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(root, options, failure), end; !failure && it != end;
       it.increment(failure)) {
    std::error_code ignored;
    if (!it->is_directory(ignored)) continue;
    if (it.depth() >= kDeepestSearch) it.disable_recursion_pending();
    if (EndsWith("/" + it->path().generic_string(), "/" + name)) found.push_back(it->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Those of the candidates that hold scans. False when one cannot be listed.
bool FindWithScans(const std::vector<fs::path>& candidates,
                   const ScanFolderQuery& query,
                   std::vector<ScanFolder>* found,
                   std::string* error) {
  for (const fs::path& candidate : candidates) {
    ScanFolder folder;
    folder.path = candidate;
    if (!ListScans(candidate, query, &folder.names, error)) return false;
    if (!folder.names.empty()) found->push_back(std::move(folder));
  }
  return true;
}

bool FindScans(const fs::path& root,
               const ScanFolderQuery& query,
               ScanFolder* folder,
               std::string* error) {
  std::vector<fs::path> candidates;
  std::string searched;
  for (const std::string& candidate : query.candidates) {
    candidates.push_back(candidate == "." ? root : root / candidate);
    searched += (searched.empty() ? "" : ", ") + (candidate == "." ? "itself" : candidate + "/");
  }
  std::vector<ScanFolder> found;
  if (!FindWithScans(candidates, query, &found, error)) return false;
  if (found.empty() && !query.name_below.empty()) {
    searched += ", any " + query.name_below + "/ below";
    const std::vector<fs::path> below = FoldersBelow(root, query.name_below);
    if (!FindWithScans(below, query, &found, error)) return false;
  }
  if (found.empty()) {
    *error = root.string() + ": no scans found, expected " +
             (query.names_are_stamps ? "<stamp in nanoseconds>" : "*") + query.extension +
             " files" + ", one a scan, in one of: " + searched;
    return false;
  }
  if (found.size() > 1) {
    std::string all;
    for (const ScanFolder& one : found) all += (all.empty() ? "" : ", ") + one.path.string();
    *error = root.string() + ": several folders hold scans (" + all +
             "); say with input.folder which one";
    return false;
  }
  *folder = std::move(found.front());
  return true;
}

// The file of stamps of the drive; empty when there is none.
fs::path FindStampFile(const fs::path& root, const fs::path& folder) {
  std::vector<fs::path> places = {folder};
  if (folder != root) places.push_back(folder.parent_path());
  places.push_back(root);
  for (const char* name : {"times.txt", "timestamps.txt", "ref_poses.txt"}) {
    for (const fs::path& place : places) {
      std::error_code ignored;
      if (fs::exists(place / name, ignored)) return place / name;
    }
  }
  return {};
}

// Sets the stamps from a file with one for each scan. `found` says whether there is one.
bool StampsFromFile(const fs::path& root, ScanFolder* folder, bool* found, std::string* error) {
  const fs::path file = FindStampFile(root, folder->path);
  *found = !file.empty();
  if (!*found) return true;
  if (!ReadStampFile(file, &folder->stamps_ns, error)) return false;
  if (folder->stamps_ns.size() != folder->names.size()) {
    *error = file.string() + ": has " + std::to_string(folder->stamps_ns.size()) +
             " stamps, expected one for each of the " + std::to_string(folder->names.size()) +
             " scans in " + folder->path.string();
    return false;
  }
  folder->stamp_origin = file.filename().string();
  return true;
}

// Sets the stamps from the names when all of them are stamps.
bool StampsFromNames(bool names_are_stamps, ScanFolder* folder, std::string* error) {
  const std::string* other = nullptr;
  for (const std::string& name : folder->names) {
    if (const std::optional<std::int64_t> stamp = StampOfStem(Stem(name))) {
      folder->stamps_ns.push_back(*stamp);
    } else if (other == nullptr) {
      other = &name;
    }
  }
  if (other == nullptr) {
    folder->stamp_origin = "file names";
    return true;
  }
  // Some stamps and some positions would give a time axis that nobody meant.
  if (names_are_stamps || !folder->stamps_ns.empty()) {
    *error = (folder->path / *other).string() +
             ": the name is no stamp, expected one like that of the other files (nanoseconds, 19 "
             "digits), or a times.txt with one stamp a scan";
    return false;
  }
  return true;
}

bool FindStamps(const fs::path& root,
                const ScanFolderQuery& query,
                ScanFolder* folder,
                std::string* error) {
  bool found = false;
  if (!StampsFromFile(root, folder, &found, error)) return false;
  if (found) return true;
  if (!StampsFromNames(query.names_are_stamps, folder, error)) return false;
  if (!folder->stamps_ns.empty()) return true;
  for (std::size_t i = 0; i < folder->names.size(); ++i) {
    folder->stamps_ns.push_back(std::llround(static_cast<double>(i) * 1e9 / query.rate));
  }
  folder->stamp_origin = FormatText("%g Hz", query.rate);
  folder->stamps_are_positions = true;
  return true;
}

// A clone without its data: better one message now than a warning for each scan.
bool CheckIsFetched(const ScanFolder& folder, std::string* error) {
  for (std::size_t i = 0; i < folder.names.size(); ++i) {
    if (!IsLfsPointer(folder.File(i), error)) return true;
  }
  return false;
}

// `root` as a drive of one scan, at its own stamp or at 0.
ScanFolder OneScan(const fs::path& root) {
  ScanFolder folder;
  folder.path = root.parent_path();
  folder.names = {root.filename().string()};
  const std::optional<std::int64_t> stamp = StampOfStem(Stem(folder.names.front()));
  folder.stamps_ns = {stamp.value_or(0)};
  folder.stamp_origin = stamp ? "file names" : "nowhere (one scan)";
  return folder;
}

}  // namespace

bool ListFiles(const fs::path& folder,
               const std::string& extension,
               std::vector<std::string>* names,
               std::string* error) {
  names->clear();
  std::error_code failure;
  if (!fs::is_directory(folder, failure)) return true;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    std::string name = it->path().filename().string();
    if (name.size() <= extension.size() || name.front() == '.' || !EndsWith(name, extension)) {
      continue;
    }
    std::error_code ignored;
    // A link to nowhere stays in the list: it is a scan of the drive, though it cannot be read.
    if (!it->is_directory(ignored)) names->push_back(std::move(name));
  }
  if (failure) {
    *error = folder.string() + ": cannot be listed: " + failure.message();
    return false;
  }
  std::sort(names->begin(), names->end(), NaturalLess);
  return true;
}

std::string WhyNotConsecutive(const std::vector<std::string>& names) {
  std::vector<std::int64_t> numbers;
  for (const std::string& name : names) {
    // The last run of digits: radar_pointcloud_12.bin, 00549.bin.
    const std::string_view stem = Stem(name);
    const std::size_t end = stem.find_last_of("0123456789");
    if (end == std::string_view::npos) return "";
    const std::size_t before = stem.find_last_not_of("0123456789", end);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::optional<std::int64_t> number = ParseInteger(stem.substr(begin, end + 1 - begin));
    if (!number) return "";
    numbers.push_back(*number);
  }
  if (numbers.size() < 2) return numbers.empty() ? "" : "there is only one scan";
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < numbers.size(); ++i) steps.push_back(numbers[i] - numbers[i - 1]);
  const std::int64_t smallest = *std::min_element(steps.begin(), steps.end());
  const auto num_jumps = static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [&](std::int64_t s) { return s != smallest; }));
  if (2 * num_jumps < steps.size() || (num_jumps == 0 && smallest < 20)) return "";
  return "the numbers in the file names are not consecutive (" + names[0] + ", " + names[1] +
         (names.size() > 2 ? ", " + names[2] : "") + (names.size() > 3 ? ", ..." : "") +
         "): these are single scans, and odometry needs scans that overlap";
}

bool CheckIsFolder(const fs::path& path, std::string* error) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (fs::is_directory(status)) return true;
  *error = path.string() + ": expected a folder with radar scans, but it " +
           (fs::exists(status) ? "is a file" : "does not exist");
  return false;
}

std::optional<ScanFolder> OpenScanFolder(const fs::path& root,
                                         const ScanFolderQuery& query,
                                         std::string* error) {
  ScanFolder folder;
  std::error_code ignored;
  if (fs::is_regular_file(root, ignored) && EndsWith(root.filename().string(), query.extension)) {
    folder = OneScan(root);
    if (!CheckIsFetched(folder, error)) return std::nullopt;
    return folder;
  }
  if (!CheckIsFolder(root, error) || !FindScans(root, query, &folder, error) ||
      !FindStamps(root, query, &folder, error) || !CheckIsFetched(folder, error)) {
    return std::nullopt;
  }
  return folder;
}

}  // namespace radive
