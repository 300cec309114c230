// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/json.h"

#include <gtest/gtest.h>

#include <atomic>
#include <clocale>
#include <string>
#include <thread>

#include "radive/util/stopwatch.h"
#include "tests/foreign_locales.h"

namespace radive {
namespace {

TEST(Json, TextAndBack) {
  const Json json = {{"b", 0.25}, {"a", {1, nullptr, "x\"y"}}};
  EXPECT_EQ(JsonText(json),
            "{\n  \"b\": 0.25,\n  \"a\": [\n    1,\n    null,\n    \"x\\\"y\"\n  ]\n}\n");
  EXPECT_EQ(ParseJson(JsonText(json)), json);
}

TEST(Json, DiscardsWhatIsNone) {
  for (const char* text : {"", "{", "[1,]", "0,5", "nan", "{} x"}) {
    EXPECT_TRUE(ParseJson(text).is_discarded()) << text;
  }
}

TEST(Json, ReplacesWhatIsNotUtf8) { EXPECT_EQ(JsonText("a\xff"), "\"a\xef\xbf\xbd\"\n"); }

TEST(Json, NumbersAreTheSameWhileAnotherThreadChangesTheLocale) {
  const testing::ForeignLocales locales;
  if (!locales.are_there()) GTEST_SKIP() << "no package `locales`";
  std::atomic<bool> stop{false};
  std::thread changer([&stop] {
    const char* const names[] = {"de_DE.UTF-8", "C"};
    for (int i = 0; !stop; ++i) std::setlocale(LC_ALL, names[i % 2]);
  });
  int num_wrong = 0;
  for (const Stopwatch time; time.Milliseconds() < 1500.0;) {
    const Json json = ParseJson("[0.75, 1e-3]");
    num_wrong += json.is_discarded() || json[0] != 0.75 || json[1] != 1e-3;
  }
  stop = true;
  changer.join();
  EXPECT_EQ(num_wrong, 0);
}

}  // namespace
}  // namespace radive
