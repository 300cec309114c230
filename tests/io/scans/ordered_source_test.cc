// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/ordered_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Scans with these stamps in tenths of a second, and as many returns as their index; recorded at
// the times in tenths of a second where there are any.
class Stored : public ScanSource {
 public:
  explicit Stored(std::vector<int> stamps, std::vector<int> records = {})
      : stamps_(std::move(stamps)), records_(std::move(records)) {}

  Status PassOver(RadarScan* scan) override {
    if (next_ == stamps_.size()) {
      error_ = "FILE: broken";
      return fails_at_end ? Status::kError : Status::kEnd;
    }
    scan->stamp_ns = 100'000'000LL * stamps_[next_];
    scan->place = "scan " + std::to_string(next_);
    scan->returns.clear();
    ++next_;
    num_read = static_cast<int>(next_);
    return Status::kScan;
  }
  Status Next(RadarScan* scan) override {
    const Status status = PassOver(scan);
    if (status == Status::kScan) scan->returns.resize(next_ - 1);
    return status;
  }
  std::optional<std::int64_t> record_ns() const override {
    if (records_.empty()) return std::nullopt;
    return 100'000'000LL * records_[next_ - 1];
  }
  std::string Description() const override { return "scans"; }
  std::optional<int> NumScans() const override { return static_cast<int>(stamps_.size()); }

  SourceFacts Facts() const override {
    SourceFacts facts;
    for (const int stamp : stamps_) {
      if (knows_stamps) facts.stamps_ns.push_back(100'000'000LL * stamp);
    }
    return facts;
  }

  bool fails_at_end = false;
  bool knows_stamps = false;
  int num_read = 0;

 private:
  const std::vector<int> stamps_, records_;
  std::size_t next_ = 0;
};

std::vector<int> Numbers(int first, int end) {
  std::vector<int> numbers;
  for (int i = first; i < end; ++i) numbers.push_back(i);
  return numbers;
}

struct Given {
  std::vector<int> stamps;  // tenths of a second
  std::vector<std::size_t> indices;
};

Given ReadAll(ScanSource* source) {
  Given given;
  RadarScan scan;
  while (source->Next(&scan) == ScanSource::Status::kScan) {
    given.stamps.push_back(static_cast<int>(scan.stamp_ns / 100'000'000));
    given.indices.push_back(scan.returns.size());
  }
  return given;
}

TEST(OrderedSource, PassesOnWhatIsInOrder) {
  OrderedSource source(std::make_unique<Stored>(Numbers(5, 40)));
  EXPECT_EQ(ReadAll(&source).stamps, Numbers(5, 40));
  EXPECT_TRUE(source.TakeWarnings().empty());
}

TEST(OrderedSource, MovesScansWithTheirStamps) {
  OrderedSource source(std::make_unique<Stored>(std::vector<int>{0, 1, 3, 2, 4}));
  const Given given = ReadAll(&source);
  EXPECT_THAT(given.stamps, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(given.indices, ElementsAre(0, 1, 3, 2, 4));
  EXPECT_THAT(source.TakeWarnings(),
              ElementsAre("scan 3: the stamp 0.200000000 is earlier than that of a scan before; it "
                          "is put in order"));
}

TEST(OrderedSource, CountsWhatItDid) {
  std::vector<int> stamps = Numbers(100, 140);
  stamps[10] = stamps[11] = stamps[20] = 0;
  for (std::size_t i = 30; i < 40; ++i) stamps[i] -= 50;
  OrderedSource source(std::make_unique<Stored>(stamps));
  EXPECT_EQ(ReadAll(&source).stamps, Numbers(100, 140));
  EXPECT_THAT(
      source.TakeWarnings(),
      ElementsAre(HasSubstr("scan 10: the stamp 0.000000000 does not fit its neighbours; "
                            "11.000000000, between its neighbours, is taken instead"),
                  HasSubstr("scan 30: the stamp 8.000000000 is where the clock was set; this stamp "
                            "and those behind it are moved by +5 s"),
                  "and 2 more: scans with bad stamps, stamped anew"));
}

// A bag gives the first of two clouds with one stamp, a folder both.
TEST(OrderedSource, RepeatedStamps) {
  OrderedSource folder(std::make_unique<Stored>(std::vector<int>{0, 1, 2, 2, 3, 4, 5}));
  EXPECT_THAT(ReadAll(&folder).stamps, ElementsAre(0, 1, 2, 2, 3, 4, 5));
  EXPECT_THAT(folder.TakeWarnings(), ElementsAre(HasSubstr("it is not used")));
  const std::vector<int> stamps = {0, 1, 2, 2, 3, 4, 5};
  OrderedSource bag(std::make_unique<Stored>(stamps, stamps));
  const Given given = ReadAll(&bag);
  EXPECT_THAT(given.stamps, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(given.indices, ElementsAre(0, 1, 2, 4, 5, 6));
  EXPECT_THAT(bag.TakeWarnings(),
              ElementsAre("scan 3: the stamp 0.200000000 is that of the scan before; it is passed "
                          "over"));
}

// What is behind is read in full, and whatever was put in order stays so.
TEST(OrderedSource, SkipsInTheOrderOfTheStamps) {
  std::vector<int> stamps = Numbers(0, 30);
  std::swap(stamps[19], stamps[20]);
  OrderedSource source(std::make_unique<Stored>(stamps));
  EXPECT_EQ(source.Skip(20), ScanSource::Status::kScan);
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 2'000'000'000);
  EXPECT_EQ(scan.returns.size(), 19u);
  EXPECT_EQ(source.Skip(9), ScanSource::Status::kScan);
  EXPECT_EQ(source.Skip(1), ScanSource::Status::kEnd);
}

// A folder knows its stamps: the same comes out, but a scan is read when it is its turn.
TEST(OrderedSource, KnownStampsNeedNoReadingAhead) {
  std::vector<int> odd = Numbers(100, 140);
  std::swap(odd[5], odd[8]);
  odd[20] = 0;
  for (std::size_t i = 30; i < 40; ++i) odd[i] -= 50;
  for (const std::vector<int>& stamps : {Numbers(0, 20), odd, {0, 1, 3, 2, 4}, {7}}) {
    OrderedSource ahead(std::make_unique<Stored>(stamps));
    auto stored = std::make_unique<Stored>(stamps);
    stored->knows_stamps = true;
    OrderedSource known(std::move(stored));
    const Given expected = ReadAll(&ahead), given = ReadAll(&known);
    EXPECT_EQ(given.stamps, expected.stamps);
    EXPECT_EQ(given.indices, expected.indices);
    EXPECT_EQ(known.TakeWarnings(), ahead.TakeWarnings());
  }
  auto stored = std::make_unique<Stored>(std::vector<int>{0, 1, 3, 4, 2, 5, 6});
  stored->knows_stamps = true;
  stored->fails_at_end = true;
  const Stored* const inner = stored.get();
  OrderedSource source(std::move(stored));
  RadarScan scan;
  for (const int num_read : {1, 2, 5, 5, 5, 6, 7}) {
    ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
    EXPECT_EQ(inner->num_read, num_read) << scan.place;
  }
  EXPECT_EQ(source.Next(&scan), ScanSource::Status::kError);
  EXPECT_EQ(source.error(), "FILE: broken");
}

TEST(OrderedSource, GivesWhatWasReadBeforeAnError) {
  auto stored = std::make_unique<Stored>(Numbers(0, 4));
  stored->fails_at_end = true;
  OrderedSource source(std::move(stored));
  EXPECT_EQ(ReadAll(&source).stamps, Numbers(0, 4));
  EXPECT_EQ(source.error(), "FILE: broken");
}

}  // namespace
}  // namespace radive
