// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/natural_order.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace radive {
namespace {

TEST(NaturalLess, OrdersEveryPairAsListed) {
  // Digits compare by value and come, as in ASCII, before letters; a prefix comes first.
  const std::vector<std::string> sorted = {"",
                                           "2.bin",
                                           "007.bin",
                                           "08",
                                           "8",
                                           "10",
                                           "010.5",
                                           "99999999999999999998",
                                           "99999999999999999999",
                                           "100000000000000000000",
                                           "scan",
                                           "scan0",
                                           "scan00a",
                                           "scan0b",
                                           "scan9",
                                           "scan10",
                                           "scan10_2",
                                           "scan10_11",
                                           "scanx"};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      EXPECT_EQ(NaturalLess(sorted[i], sorted[j]), i < j) << sorted[i] << " | " << sorted[j];
    }
  }
}

}  // namespace
}  // namespace radive
