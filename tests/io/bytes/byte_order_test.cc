// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/byte_order.h"

#include <gtest/gtest.h>

#include <string_view>

#include "radive/io/bytes/byte_reader.h"

namespace radive {
namespace {

using namespace std::string_view_literals;

TEST(ByteOrder, NumbersByHand) {
  constexpr std::string_view kBytes = "\x01\x02\x03\x84\x05\x06\x07\x08"sv;
  EXPECT_EQ(NumberAt<std::uint8_t>(kBytes.data() + 3), 0x84);
  EXPECT_EQ(NumberAt<std::int8_t>(kBytes.data() + 3), -124);
  EXPECT_EQ(NumberAt<std::uint16_t>(kBytes.data()), 0x0201);
  EXPECT_EQ(NumberAt<std::uint16_t>(kBytes.data(), true), 0x0102);
  EXPECT_EQ(NumberAt<std::uint32_t>(kBytes.data()), 0x84030201U);
  EXPECT_EQ(NumberAt<std::int32_t>(kBytes.data()), -0x7BFCFDFF);
  EXPECT_EQ(NumberAt<std::uint32_t>(kBytes.data(), true), 0x01020384U);
  EXPECT_EQ(NumberAt<std::uint64_t>(kBytes.data()), 0x0807060584030201U);
  EXPECT_EQ(NumberAt<std::uint64_t>(kBytes.data(), true), 0x0102038405060708U);
  // 1.5 is 0x3FC00000 and 0x3FF8000000000000.
  EXPECT_EQ(NumberAt<float>("\x00\x00\xC0\x3F"sv.data()), 1.5F);
  EXPECT_EQ(NumberAt<float>("\x3F\xC0\x00\x00"sv.data(), true), 1.5F);
  EXPECT_EQ(NumberAt<double>("\x3F\xF8\x00\x00\x00\x00\x00\x00"sv.data(), true), 1.5);
}

TEST(ByteOrder, WhatIsAppendedIsLittleEndian) {
  EXPECT_EQ(LittleEndian(std::int8_t{-2}), "\xFE");
  EXPECT_EQ(LittleEndian(std::uint16_t{0x0102}), "\x02\x01");
  EXPECT_EQ(LittleEndian(std::uint64_t{1} << 56), "\0\0\0\0\0\0\0\1"sv);
  EXPECT_EQ(LittleEndian(-1.5F), "\x00\x00\xC0\xBF"sv);
  EXPECT_EQ(LittleEndian(1.5), "\0\0\0\0\0\0\xF8\x3F"sv);
}

TEST(ByteOrder, AReaderGivesZeroBeyondTheEnd) {
  ByteReader reader("\x3F\xC0\x00\x00\x07"sv);
  EXPECT_EQ(reader.Number<float>(/*is_big_endian=*/true), 1.5F);
  EXPECT_EQ(reader.Number<std::uint16_t>(), 0);
  EXPECT_TRUE(reader.failed());
}

}  // namespace
}  // namespace radive
