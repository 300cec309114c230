// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace radive {

// Says of a file by its name whether it holds points.
using HoldsPointsTest = std::function<bool(const std::string& name)>;

// Takes what is no scan out of the files of a folder (poses.csv and map.pcd beside 0001.pcd ...),
// and returns it. Scans of a drive are named alike but for their numbers: where at least half of
// the names are, and at least two, those without any number are foreign. Names that differ
// otherwise, and all names where no two are alike, are asked for with `holds_points`, where there
// is such a test.
std::vector<std::string> TakeOutForeign(const HoldsPointsTest& holds_points,
                                        std::vector<std::string>* names);

}  // namespace radive
