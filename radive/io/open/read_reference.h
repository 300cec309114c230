// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "radive/io/trajectories/reference.h"
#include "radive/io/trajectories/reference_options.h"

namespace radive {

// Reads the ground truth at `path`: a file, or a folder in which it lies where its dataset puts it.
// With format auto a file is known by its name or by the number of columns in its first line, a
// folder by what it holds. `clip`: of RaFlow, see InputOptions::clip. `options` must be valid.
// Nothing, with the place, what was found and what was expected in `error`, when that fails.
std::optional<Reference> ReadReference(const std::filesystem::path& path,
                                       const ReferenceOptions& options,
                                       int clip,
                                       std::string* error);

}  // namespace radive
