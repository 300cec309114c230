// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/scan_folder.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/scans/foreign_files.h"
#include "radive/io/scans/scan_stamps.h"
#include "radive/io/scans/stamp_names.h"
#include "radive/util/natural_order.h"
#include "radive/util/number_text.h"
#include "radive/util/system_message.h"
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

// Takes what is no scan out of the files, with a warning.
void LeaveOutForeign(const ScanFolderQuery& query, ScanFolder* folder) {
  if (query.names_are_stamps) return;
  HoldsPointsTest test;
  if (query.holds_points) {
    test = [&](const std::string& name) { return query.holds_points(folder->path / name); };
  }
  const std::vector<std::string> foreign = TakeOutForeign(test, &folder->names);
  if (foreign.empty()) return;
  std::string warning = folder->path.string() + ": left out, for no scans by name or content: ";
  constexpr std::size_t kMostNames = 5;
  for (std::size_t i = 0; i < std::min(foreign.size(), kMostNames); ++i) {
    warning += (i == 0 ? "" : ", ") + foreign[i];
  }
  if (foreign.size() > kMostNames) {
    warning += " and " + std::to_string(foreign.size() - kMostNames) + " more";
  }
  folder->warnings.push_back(std::move(warning));
}

// Those of the candidates that hold scans; `left_out` gets the warnings on all of them. False when
// one cannot be listed.
bool FindWithScans(const std::vector<fs::path>& candidates,
                   const ScanFolderQuery& query,
                   std::vector<ScanFolder>* found,
                   std::vector<std::string>* left_out,
                   std::string* error) {
  for (const fs::path& candidate : candidates) {
    ScanFolder folder;
    folder.path = candidate;
    if (!ListScans(candidate, query, &folder.names, error)) return false;
    LeaveOutForeign(query, &folder);
    left_out->insert(left_out->end(), folder.warnings.begin(), folder.warnings.end());
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
    const fs::path place = candidate == "." ? root : root / candidate;
    // A dataset may name one of the usual folders.
    if (std::find(candidates.begin(), candidates.end(), place) != candidates.end()) continue;
    candidates.push_back(place);
    searched += (searched.empty() ? "" : ", ") + (candidate == "." ? "itself" : candidate + "/");
  }
  std::vector<ScanFolder> found;
  std::vector<std::string> left_out;
  if (!FindWithScans(candidates, query, &found, &left_out, error)) return false;
  if (found.empty() && !query.name_below.empty()) {
    searched += ", any " + query.name_below + "/ below";
    const std::vector<fs::path> below = FoldersBelow(root, query.name_below);
    if (!FindWithScans(below, query, &found, &left_out, error)) return false;
  }
  if (found.empty()) {
    *error = root.string() + ": no scans found, expected " +
             (query.names_are_stamps ? "<stamp in nanoseconds>" : "*") + query.extension +
             " files" + ", one a scan, in one of: " + searched;
    for (const std::string& warning : left_out) *error += "; " + warning;
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
      // A link to nowhere counts: it is an error that the stamps cannot be read.
      std::error_code ignored;
      if (fs::exists(fs::symlink_status(place / name, ignored))) return place / name;
    }
  }
  return {};
}

std::string RateText(double rate) {
  return rate > 0.0 ? FormatText("%g scans per second are taken (input.rate)", rate)
                    : AssumedRateText();
}

// "times.txt", with the unit where it is not the usual one.
std::string OriginText(const std::string& place, const StampSequence& sequence) {
  const bool is_usual = sequence.unit == "s" || sequence.unit == "ns" || sequence.unit == "digits";
  return is_usual ? place : place + " (" + sequence.unit + ")";
}

// Sets the stamps from a file with one for each scan. `found` says whether there is one.
bool StampsFromFile(
    const fs::path& root, double rate, ScanFolder* folder, bool* found, std::string* error) {
  const fs::path file = FindStampFile(root, folder->path);
  *found = !file.empty();
  if (!*found) return true;
  std::optional<StampSequence> sequence = ReadStampFile(file, rate, error);
  if (!sequence) return false;
  folder->stamps_ns = std::move(sequence->stamps_ns);
  if (folder->stamps_ns.size() != folder->names.size()) {
    *error = file.string() + ": has " + std::to_string(folder->stamps_ns.size()) +
             " stamps, expected one for each of the " + std::to_string(folder->names.size()) +
             " scans in " + folder->path.string();
    return false;
  }
  folder->stamp_origin = OriginText(file.filename().string(), *sequence);
  if (!sequence->doubt.empty()) {
    folder->stamp_doubt = file.string() + ": " + sequence->doubt;
    if (sequence->rate_is_used) folder->stamp_doubt += "; " + RateText(rate);
  }
  return true;
}

// Sets the stamps from the names when all of them hold one, and puts the scans in their order.
bool StampsFromNames(bool names_are_stamps, ScanFolder* folder, std::string* error) {
  std::vector<std::string> stems;
  for (const std::string& name : folder->names) stems.emplace_back(Stem(name));
  std::optional<std::size_t> odd;
  std::optional<StampSequence> sequence = StampsOfNames(stems, &odd);
  // Some stamps and some positions would give a time axis that nobody meant.
  if (odd || (names_are_stamps && !sequence)) {
    *error = folder->File(odd.value_or(0)).string() +
             ": the name is no stamp, expected one like that of the other files (nanoseconds, 19 "
             "digits), or a times.txt with one stamp a scan";
    return false;
  }
  if (!sequence) return true;
  folder->stamp_origin = OriginText("file names", *sequence);
  folder->stamps_ns = std::move(sequence->stamps_ns);
  if (std::is_sorted(folder->stamps_ns.begin(), folder->stamps_ns.end())) return true;
  std::vector<std::pair<std::int64_t, std::string>> scans;
  for (std::size_t i = 0; i < folder->names.size(); ++i) {
    scans.emplace_back(folder->stamps_ns[i], std::move(folder->names[i]));
  }
  std::stable_sort(scans.begin(), scans.end(), [](const auto& one, const auto& other) {
    return one.first < other.first;
  });
  for (std::size_t i = 0; i < scans.size(); ++i) {
    folder->stamps_ns[i] = scans[i].first;
    folder->names[i] = std::move(scans[i].second);
  }
  return true;
}

// The last run of digits in each name: radar_pointcloud_12.bin, 00549.bin. None when a name has
// none.
std::vector<std::int64_t> NumbersOf(const std::vector<std::string>& names) {
  std::vector<std::int64_t> numbers;
  for (const std::string& name : names) {
    const std::string_view stem = Stem(name);
    const std::size_t end = stem.find_last_of("0123456789");
    if (end == std::string_view::npos) return {};
    const std::size_t before = stem.find_last_not_of("0123456789", end);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::optional<std::int64_t> number = ParseInteger(stem.substr(begin, end + 1 - begin));
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::int64_t> StepsOf(const std::vector<std::int64_t>& numbers) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < numbers.size(); ++i) steps.push_back(numbers[i] - numbers[i - 1]);
  return steps;
}

// The positions of the scans in the drive: those of their numbers where they count up evenly and
// only some are missing, whose time passes all the same.
std::vector<double> PositionsOf(ScanFolder* folder) {
  std::vector<double> positions;
  for (std::size_t i = 0; i < folder->names.size(); ++i) {
    positions.push_back(static_cast<double>(i));
  }
  const std::vector<std::int64_t> numbers = NumbersOf(folder->names);
  if (numbers.size() < 3 || !WhyNotConsecutive(folder->names).empty()) return positions;
  const std::vector<std::int64_t> steps = StepsOf(numbers);
  const std::int64_t step = *std::min_element(steps.begin(), steps.end());
  const auto first_gap =
      std::find_if(steps.begin(), steps.end(), [&](std::int64_t other) { return other != step; });
  if (step <= 0 || first_gap == steps.end()) return positions;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    positions[i] = static_cast<double>(numbers[i] - numbers[0]) / static_cast<double>(step);
  }
  const std::int64_t num_missing =
      (numbers.back() - numbers.front()) / step + 1 - static_cast<std::int64_t>(numbers.size());
  folder->warnings.push_back(
      folder->File(static_cast<std::size_t>(first_gap - steps.begin())).string() + ": " +
      std::to_string(num_missing) + " of the numbers in the file names are missing, the first " +
      "behind this one; their time passes");
  return positions;
}

bool FindStamps(const fs::path& root,
                const ScanFolderQuery& query,
                ScanFolder* folder,
                std::string* error) {
  bool found = false;
  if (!StampsFromFile(root, query.rate, folder, &found, error)) return false;
  if (found) return true;
  if (!StampsFromNames(query.names_are_stamps, folder, error)) return false;
  if (!folder->stamps_ns.empty()) return true;
  for (const double position : PositionsOf(folder)) {
    folder->stamps_ns.push_back(StampAt(position, query.rate));
  }
  folder->stamp_origin = FormatText("%g Hz", query.rate > 0.0 ? query.rate : kAssumedRate);
  folder->stamps_are_positions = true;
  if (!(query.rate > 0.0) && folder->names.size() > 1) {
    folder->stamp_doubt = folder->path.string() + ": the scans have no stamps; " + RateText(0.0);
  }
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
  std::optional<std::size_t> odd;
  const auto sequence = StampsOfNames({std::string(Stem(folder.names.front()))}, &odd);
  folder.stamps_ns = {sequence ? sequence->stamps_ns.front() : 0};
  folder.stamp_origin = sequence ? "file names" : "nowhere (one scan)";
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
    if (name.size() <= extension.size() || name.front() == '.' ||
        !EndsWith(LowerCase(name), extension)) {
      continue;
    }
    std::error_code ignored;
    // A link to nowhere stays in the list: it is a scan of the drive, though it cannot be read.
    if (!it->is_directory(ignored)) names->push_back(std::move(name));
  }
  if (failure) {
    *error = folder.string() + ": cannot be listed: " + SystemMessage(failure);
    return false;
  }
  std::sort(names->begin(), names->end(), NaturalLess);
  return true;
}

std::string WhyNotConsecutive(const std::vector<std::string>& names) {
  const std::vector<std::int64_t> numbers = NumbersOf(names);
  if (numbers.size() < 2) return numbers.empty() ? "" : "there is only one scan";
  const std::vector<std::int64_t> steps = StepsOf(numbers);
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
  if (fs::is_regular_file(root, ignored) &&
      EndsWith(LowerCase(root.filename().string()), query.extension)) {
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
