// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/compression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "radive/util/random.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

// Half of it packs well, half not at all.
std::string MadeBytes(std::size_t size) {
  Random random(3);
  std::string bytes(size, 'a');
  for (std::size_t i = size / 2; i < size; ++i) bytes[i] = static_cast<char>(random.Bits());
  return bytes;
}

class CompressionTest : public ::testing::TestWithParam<Compression> {};

TEST_P(CompressionTest, ComesBack) {
  for (const std::size_t size : {0, 1, 1000, 3000000}) {
    const std::string bytes = MadeBytes(size);
    std::string unpacked = "old";
    std::string error;
    EXPECT_TRUE(Decompress(GetParam(), Compress(GetParam(), bytes), size, &unpacked, &error))
        << error;
    EXPECT_EQ(unpacked, bytes);
  }
}

TEST_P(CompressionTest, AWrongSizeIsAnErrorAndCostsNoMemory) {
  const std::string bytes = MadeBytes(1000);
  const std::string packed = Compress(GetParam(), bytes);
  std::string unpacked;
  std::string error;
  EXPECT_FALSE(Decompress(GetParam(), packed, 999, &unpacked, &error));
  EXPECT_EQ(unpacked, bytes.substr(0, 999));
  EXPECT_NE(error, "");
  EXPECT_FALSE(Decompress(GetParam(), packed, std::uint64_t{1} << 40, &unpacked, &error));
  EXPECT_EQ(unpacked, bytes);
  EXPECT_THAT(error, HasSubstr("1000 bytes instead of 1099511627776"));
  EXPECT_LT(unpacked.capacity(), 100000u);
}

TEST_P(CompressionTest, WhatIsInFrontOfTheCutComesBack) {
  const std::string bytes = MadeBytes(3000000);
  const std::string packed = Compress(GetParam(), bytes);
  std::string unpacked;
  std::string error;
  const std::string cut = packed.substr(0, packed.size() - 5);
  EXPECT_FALSE(Decompress(GetParam(), cut, bytes.size(), &unpacked, &error));
  EXPECT_NE(error, "");
  // Blocks have 64 KiB to 900 kB.
  EXPECT_GT(unpacked.size(), 1800000u);
  EXPECT_LT(unpacked.size(), bytes.size() + 1);
  EXPECT_EQ(unpacked, bytes.substr(0, unpacked.size()));
}

TEST_P(CompressionTest, NamesAreThoseInTheFiles) {
  EXPECT_EQ(CompressionOfName(NameOf(GetParam())), GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    All,
    CompressionTest,
    ::testing::Values(Compression::kNone, Compression::kBz2, Compression::kLz4, Compression::kZstd),
    [](const auto& test) { return std::string(NameOf(test.param)); });

TEST(CompressionOfName, OthersAreUnknown) {
  EXPECT_EQ(CompressionOfName(""), Compression::kNone);
  EXPECT_EQ(CompressionOfName("gzip"), std::nullopt);
  EXPECT_EQ(CompressionOfName("LZ4"), std::nullopt);
}

}  // namespace
}  // namespace radive
