// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scan_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

#include "radive/io/record_file.h"
#include "radive/io/scan_stamps.h"
#include "radive/util/natural_order.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".bin";
constexpr int kDeepestSearch = 6;

std::string_view Stem(std::string_view name) {
  return name.substr(0, name.size() - kExtension.size());
}

bool IsScanName(std::string_view name, bool names_are_stamps) {
  if (name.size() <= kExtension.size() || name.front() == '.') return false;
  if (name.substr(name.size() - kExtension.size()) != kExtension) return false;
  return !names_are_stamps || Stem(name).find_first_not_of("0123456789") == std::string_view::npos;
}

// Writes the names of the scan files in `folder` to `names`, sorted; none if there is no such
// folder. False when the folder is there but cannot be listed.
bool ListScans(const fs::path& folder,
               bool names_are_stamps,
               std::vector<std::string>* names,
               std::string* error) {
  names->clear();
  std::error_code failure;
  if (!fs::is_directory(folder, failure)) return true;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    std::string name = it->path().filename().string();
    std::error_code ignored;
    // A link to nowhere stays in the list: it is a scan of the drive, though it cannot be read.
    if (IsScanName(name, names_are_stamps) && !it->is_directory(ignored)) {
      names->push_back(std::move(name));
    }
  }
  if (failure) {
    *error = folder.string() + ": cannot be listed: " + failure.message();
    return false;
  }
  std::sort(names->begin(), names->end(), NaturalLess);
  return true;
}

// Folders called `name` below `root`, sorted.
std::vector<fs::path> FoldersBelow(const fs::path& root, const std::string& name) {
  std::vector<fs::path> found;
  std::error_code failure;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(root, options, failure), end; !failure && it != end;
       it.increment(failure)) {
    std::error_code ignored;
    if (!it->is_directory(ignored)) continue;
    if (it.depth() >= kDeepestSearch) it.disable_recursion_pending();
    if (it->path().filename() == name) found.push_back(it->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Those of the candidates that hold scans. False when one cannot be listed.
bool FindWithScans(const std::vector<fs::path>& candidates,
                   bool names_are_stamps,
                   std::vector<ScanFolder>* found,
                   std::string* error) {
  for (const fs::path& candidate : candidates) {
    ScanFolder folder;
    folder.path = candidate;
    if (!ListScans(candidate, names_are_stamps, &folder.names, error)) return false;
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
  if (!FindWithScans(candidates, query.names_are_stamps, &found, error)) return false;
  if (found.empty() && !query.name_below.empty()) {
    searched += ", any " + query.name_below + "/ below";
    const std::vector<fs::path> below = FoldersBelow(root, query.name_below);
    if (!FindWithScans(below, query.names_are_stamps, &found, error)) return false;
  }
  if (found.empty()) {
    *error = root.string() + ": no scans found, expected " +
             (query.names_are_stamps ? "<stamp in nanoseconds>.bin files" : "*.bin files") +
             ", one a scan, in one of: " + searched;
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

// Sets the stamps from times.txt beside the scans or in `root`. `found` says whether there is one.
bool StampsFromFile(const fs::path& root, ScanFolder* folder, bool* found, std::string* error) {
  for (const fs::path& place : {folder->path, root}) {
    const fs::path file = place / "times.txt";
    std::error_code ignored;
    *found = fs::exists(file, ignored);
    if (!*found) continue;
    if (!ReadStampFile(file, &folder->stamps_ns, error)) return false;
    if (folder->stamps_ns.size() != folder->names.size()) {
      *error = file.string() + ": has " + std::to_string(folder->stamps_ns.size()) +
               " stamps, expected one for each of the " + std::to_string(folder->names.size()) +
               " scans in " + folder->path.string();
      return false;
    }
    folder->stamp_origin = "times.txt";
    return true;
  }
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
  char rate[40];
  std::snprintf(rate, sizeof(rate), "%g Hz", query.rate);
  folder->stamp_origin = rate;
  return true;
}

// A clone without its data: better one message now than a warning for each scan.
bool CheckIsFetched(const ScanFolder& folder, std::string* error) {
  for (std::size_t i = 0; i < folder.names.size(); ++i) {
    if (!IsLfsPointer(folder.File(i), error)) return true;
  }
  return false;
}

}  // namespace

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
  if (!CheckIsFolder(root, error) || !FindScans(root, query, &folder, error) ||
      !FindStamps(root, query, &folder, error) || !CheckIsFetched(folder, error)) {
    return std::nullopt;
  }
  return folder;
}

}  // namespace radive
