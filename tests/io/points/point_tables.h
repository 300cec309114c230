// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive::testing {

// The (first) number of the field called `name` in each point, in order.
inline std::vector<double> ValuesOf(const PointTable& table, const std::string& name) {
  std::vector<double> values;
  for (const PointField& field : table.fields) {
    if (field.name != name) continue;
    for (std::size_t i = 0; i < table.num_points; ++i) {
      values.push_back(ReadNumber(
          table.data + i * table.stride + field.offset, field.type, table.is_big_endian));
    }
    return values;
  }
  ADD_FAILURE() << "no field " << name;
  return values;
}

}  // namespace radive::testing
