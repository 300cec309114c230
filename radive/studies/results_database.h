// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "radive/studies/run_record.h"

namespace radive {

// Writes an SQLite database with the tables "results" and "timings", whose columns are those of
// results.csv and timings.csv. It appears whole or not at all.
bool WriteResultsDatabase(const std::filesystem::path& file,
                          const std::vector<RunRecord>& records,
                          std::string* error);

}  // namespace radive
