// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace radive {

// What OpenScanFolder() looks for.
struct ScanFolderQuery {
  // Folders that may hold the scans, relative to the input; "." is the input itself. Exactly one of
  // them must.
  std::vector<std::string> candidates;

  // When no candidate holds scans: a folder ("Continental", "LiDAR/Aeva") to look for anywhere
  // below the input, not deeper than six folders. Empty: none.
  std::string name_below;

  // Of the scan files.
  std::string extension = ".bin";

  // True: the names of the files are stamps (and files with other names are no scans).
  // False: any name will do.
  bool names_are_stamps = false;

  // Scans per second [Hz], where neither times.txt nor the names give stamps; 0: not known.
  double rate = 0.0;

  // Says whether a file holds points, where its name does not; null: all do.
  std::function<bool(const std::filesystem::path& file)> holds_points;

  // Looks in this folder alone, as the user names it: of the input, or anywhere below.
  void LookOnlyIn(const std::string& folder) {
    candidates = {folder};
    name_below = folder;
  }
};

// A folder with one file a scan.
struct ScanFolder {
  std::filesystem::path path;
  std::vector<std::string> names;       // of the files, numbers in them in the order of their value
  std::vector<std::int64_t> stamps_ns;  // one a file [ns]
  std::string stamp_origin;             // for the log: "times.txt", "file names", "10 Hz"
  std::string stamp_doubt;              // a warning on the stamps; empty: none
  std::vector<std::string> warnings;    // on the files
  bool stamps_are_positions = false;    // position / rate, for want of anything better

  std::filesystem::path File(std::size_t index) const { return path / names[index]; }
};

// Finds the folder with the scans of the drive `root`, lists them and finds their stamps:
// 1. times.txt or timestamps.txt beside the scans, in the folder above them or in `root`: one stamp
//    a scan, see ReadStampFile(); or the first column of ref_poses.txt there (Doppler-ICP);
// 2. the names, if all hold stamps, see StampsOfNames(); the scans are then in their order;
// 3. position / rate, where a number that is missing in the names keeps its place; a rate that is
// not known is kAssumedRate, with a warning. Hidden files are left out, and with a warning what is
// no scan, see TakeOutForeign(). `root` may be one scan file as well. Nothing, with the place and
// what was expected there in `error`, when `root` is no folder, there are no scans or several
// folders with scans, when the number of lines of the file of stamps is not that of the scans, or
// when every scan is a Git-LFS pointer.
std::optional<ScanFolder> OpenScanFolder(const std::filesystem::path& root,
                                         const ScanFolderQuery& query,
                                         std::string* error);

// For scans that are numbered, not stamped: says so when most of the numbers do not follow one
// another (in even steps); empty when they do.
std::string WhyNotConsecutive(const std::vector<std::string>& names);

// Names of the files in `folder` that end in `extension` (lower case; that of the names does not
// matter), hidden ones left out, numbers in them in
// the order of their value; none if there is no such folder. False, with the reason in `error`,
// when the folder cannot be listed.
bool ListFiles(const std::filesystem::path& folder,
               const std::string& extension,
               std::vector<std::string>* names,
               std::string* error);

// False, with a message in `error`, unless `path` is a folder.
bool CheckIsFolder(const std::filesystem::path& path, std::string* error);

}  // namespace radive
