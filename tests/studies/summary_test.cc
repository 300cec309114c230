// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace radive {
namespace {

using ::testing::HasSubstr;

Study TwoByTwo() {
  Study study;
  study.name = "made";
  study.seeds = {0, 1, 2};
  for (const char* name : {"a", "b"}) {
    StudySequence sequence;
    sequence.name = name;
    study.sequences.push_back(sequence);
  }
  study.variants = {{"ours", "Ours", "", 0, ""}, {"icp", "ICP", "", 0, ""}};
  return study;
}

RunRecord Record(const std::string& sequence,
                 const std::string& variant,
                 int seed,
                 double ate_t,
                 int scans = 100) {
  RunRecord record;
  record.sequence = sequence;
  record.variant = variant;
  record.seed = seed;
  record.status = "ok";
  record.scans = scans;
  record.scores.ate_t = ate_t;
  record.scores.ate_r = 1.0;
  return record;
}

const SummaryRow& Find(const std::vector<SummaryRow>& rows,
                       const std::string& variant,
                       const std::string& sequence) {
  return *std::find_if(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.variant == variant && row.sequence == sequence && row.metric == "ate_t";
  });
}

TEST(Summary, GivesMediansSpreadAndPairedRatios) {
  const std::vector<SummaryRow> rows = Summarise(TwoByTwo(),
                                                 {Record("a", "ours", 0, 1.0),
                                                  Record("a", "ours", 1, 2.0),
                                                  Record("a", "ours", 2, 4.0),
                                                  Record("b", "ours", 0, 10.0),
                                                  Record("a", "icp", 0, 2.0),
                                                  Record("a", "icp", 1, 6.0),
                                                  Record("a", "icp", 2, 4.0),
                                                  Record("b", "icp", 0, 5.0)});
  ASSERT_EQ(rows.size(), 2u * 3u * 4u);
  const SummaryRow& ours = Find(rows, "ours", "a");
  EXPECT_EQ(ours.runs, 3);
  EXPECT_EQ(ours.ok, 3);
  EXPECT_DOUBLE_EQ(*ours.median, 2.0);
  EXPECT_DOUBLE_EQ(*ours.q25, 1.5);
  EXPECT_DOUBLE_EQ(*ours.q75, 3.0);
  EXPECT_DOUBLE_EQ(*ours.min, 1.0);
  EXPECT_DOUBLE_EQ(*ours.max, 4.0);
  EXPECT_DOUBLE_EQ(*ours.ratio.value, 1.0);

  // Run by run 2, 3 and 1 times as much, and 1, 4 and 0 m more.
  const SummaryRow& icp = Find(rows, "icp", "a");
  EXPECT_EQ(icp.pairs, 3);
  EXPECT_NEAR(*icp.ratio.value, 2.0, 1e-12);
  EXPECT_NEAR(*icp.ratio.low, 1.0, 1e-12);
  EXPECT_NEAR(*icp.ratio.high, 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(*icp.difference.value, 1.0);
  EXPECT_FALSE(icp.ratio_over_drives.low);

  // With sequence b, ratio 0.5: the median of 2, 3, 1, 0.5 in the logarithm is sqrt(2).
  const SummaryRow& all = Find(rows, "icp", "*");
  EXPECT_EQ(all.pairs, 4);
  EXPECT_NEAR(*all.ratio.value, 1.41421356237, 1e-9);
}

TEST(Summary, LeavesOutWhatCannotBeCompared) {
  RunRecord failed = Record("a", "icp", 0, 0.0);
  failed.status = "failed";
  failed.scores = RunScores();
  RunRecord absent = Record("b", "icp", 0, 0.0);
  absent.status = "absent";
  absent.scores = RunScores();
  const std::vector<SummaryRow> rows = Summarise(TwoByTwo(),
                                                 {Record("a", "ours", 0, 1.0),
                                                  Record("a", "ours", 1, 1.0),
                                                  failed,
                                                  Record("a", "icp", 1, 3.0, /*scans=*/50),
                                                  absent});
  const SummaryRow& icp = Find(rows, "icp", "a");
  EXPECT_EQ(icp.runs, 2);
  EXPECT_EQ(icp.ok, 1);
  EXPECT_EQ(icp.pairs, 0);  // the one twin ran over more scans
  EXPECT_FALSE(icp.ratio.value);
  EXPECT_EQ(Find(rows, "icp", "b").runs, 0);
  const std::string text = SummaryMarkdown(TwoByTwo(), rows);
  EXPECT_THAT(text, HasSubstr("| ICP | 3.000 / 1.00 (1 of 2) | - | - | - | 0 |"));
  EXPECT_THAT(SummaryCsv(rows), HasSubstr("\nicp,b,ate_t,0,0,,,,,,0,,,,,,,,\n"));
}

TEST(Summary, DrivesAreDrawnWhenThereAreThree) {
  Study study = TwoByTwo();
  study.seeds = {0};
  StudySequence third;
  third.name = "c";
  study.sequences.push_back(third);
  const std::vector<SummaryRow> rows = Summarise(study,
                                                 {Record("a", "ours", 0, 1.0),
                                                  Record("b", "ours", 0, 1.0),
                                                  Record("c", "ours", 0, 1.0),
                                                  Record("a", "icp", 0, 2.0),
                                                  Record("b", "icp", 0, 4.0),
                                                  Record("c", "icp", 0, 8.0)});
  const SummaryRow& all = Find(rows, "icp", "*");
  EXPECT_NEAR(*all.ratio.value, 4.0, 1e-12);
  EXPECT_FALSE(all.ratio.low);  // one run a drive
  EXPECT_NEAR(*all.ratio_over_drives.low, 2.0, 1e-12);
  EXPECT_NEAR(*all.ratio_over_drives.high, 8.0, 1e-12);
}

}  // namespace
}  // namespace radive
