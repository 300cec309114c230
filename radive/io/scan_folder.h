// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace radive {

// What OpenScanFolder() looks for.
struct ScanFolderQuery {
  // Folders that may hold the scans, relative to the input; "." is the input itself. Exactly one of
  // them must.
  std::vector<std::string> candidates;

  // When no candidate holds scans: the name of a folder to look for anywhere below the input, not
  // deeper than six folders. Empty: none.
  std::string name_below;

  // True: the names of the files are stamps (and files with other names are no scans).
  // False: any name will do.
  bool names_are_stamps = false;

  // Scans a second [Hz], where neither times.txt nor the names give stamps.
  double rate = 10.0;
};

// A folder with one .bin file a scan.
struct ScanFolder {
  std::filesystem::path path;
  std::vector<std::string> names;       // of the files, numbers in them in the order of their value
  std::vector<std::int64_t> stamps_ns;  // one a file [ns]
  std::string stamp_origin;             // for the log: "times.txt", "file names", "10 Hz"

  std::filesystem::path File(std::size_t index) const { return path / names[index]; }
};

// Finds the folder with the scans of the drive `root`, lists them and finds their stamps:
// 1. times.txt beside the scans or in `root`: one stamp a scan, see ReadStampFile();
// 2. the names, if all are stamps, see StampOfStem();
// 3. position / rate.
// Hidden files are left out. Nothing, with the place and what was expected there in `error`, when
// `root` is no folder, there are no scans or several folders with scans, when the number of lines
// of times.txt is not that of the scans, or when every scan is a Git-LFS pointer.
std::optional<ScanFolder> OpenScanFolder(const std::filesystem::path& root,
                                         const ScanFolderQuery& query,
                                         std::string* error);

// False, with a message in `error`, unless `path` is a folder.
bool CheckIsFolder(const std::filesystem::path& path, std::string* error);

}  // namespace radive
