// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// Opens the drive at `path` in the form that `options` declare. Null when that fails; `error` then
// says what was found where, and what was expected. Opening reads no scans, apart from the first
// file, only lists them.
std::unique_ptr<ScanSource> OpenScanSource(const std::string& path,
                                           const InputOptions& options,
                                           std::string* error);

}  // namespace radive
