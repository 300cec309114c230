// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// Formats with one self-describing file of points a scan.
enum class PointFileFormat { kPcd, kPly, kCsv, kNpy, kYaml };

// "PCD", ...
const char* NameOf(PointFileFormat format);

// ".pcd", ...
const char* ExtensionOf(PointFileFormat format);

// A folder with one such file a scan, or one such file. `options` must be valid; input.layout names
// the columns of npy files. Null, with the place and the expectation in `error`, when `path` holds
// none. `more_folders` are looked at besides the usual ones.
std::unique_ptr<ScanSource> OpenPointFileSource(const std::filesystem::path& path,
                                                PointFileFormat format,
                                                const InputOptions& options,
                                                std::string* error,
                                                const std::vector<std::string>& more_folders = {});

}  // namespace radive
