// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/points/point_table.h"
#include "tests/io/points/point_tables.h"

namespace radive::testing {

// Runs a parser of point files over bytes that outlive the table, which may point into them.
template <typename Parser>
class ParserTest : public ::testing::Test {
 protected:
  explicit ParserTest(Parser parser) : parser_(parser) {}

  bool Parse(const std::string& bytes) {
    bytes_ = bytes;
    remarks_.clear();
    error_.clear();
    return parser_(bytes_, &table_, &remarks_, &error_);
  }
  // Values of the field in all points.
  std::vector<double> Values(const std::string& name) const { return ValuesOf(table_, name); }

  const Parser parser_;
  std::string bytes_;
  PointTable table_;
  std::vector<std::string> remarks_;
  std::string error_;
};

}  // namespace radive::testing
