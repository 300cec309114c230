// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

TEST(ParseAxes, SaysWhereForwardLeftAndUpComeFrom) {
  const Eigen::Vector3d stored(1, 2, 3);
  EXPECT_EQ(ParseAxes("+x+y+z")->Apply(stored), stored);
  EXPECT_EQ(ParseAxes("flu")->Apply(stored), stored);
  // 10 m ahead, 1 m to the right, 2 m below, as right-down-forward has it.
  EXPECT_EQ(ParseAxes("rdf")->Apply({1, 2, 10}), Eigen::Vector3d(10, -1, -2));
  // The TI driver's cloud as reve maps it: x' = -y, y' = x.
  EXPECT_EQ(ParseAxes("-y+x+z")->Apply(stored), Eigen::Vector3d(-2, 1, 3));
  EXPECT_EQ(ParseAxes("-y+x+z")->ToString(), "-y+x+z");
  EXPECT_TRUE(ParseAxes("flu")->IsIdentity());
  EXPECT_FALSE(ParseAxes("rdf")->IsIdentity());
  for (const char* text : {"", "xyz", "+x+y", "+x+y+y", "+x+y+w", "x+y+z+", "FLU", "+x+y+z "}) {
    EXPECT_FALSE(ParseAxes(text)) << text;
  }
}

// `count` scans with the same returns.
class SameScans : public ScanSource {
 public:
  SameScans(std::vector<Eigen::Vector3d> positions, int count)
      : positions_(std::move(positions)), count_(count) {}
  Status Next(RadarScan* scan) override {
    if (next_ == count_) return Status::kEnd;
    scan->stamp_ns = next_++;
    scan->returns.clear();
    for (const Eigen::Vector3d& position : positions_) {
      scan->returns.emplace_back().position = position;
      scan->returns.back().doppler = -3.0;
    }
    return Status::kScan;
  }
  std::string Description() const override { return "the same scans"; }
  std::optional<int> NumScans() const override { return count_; }

 private:
  const std::vector<Eigen::Vector3d> positions_;
  const int count_;
  int next_ = 0;
};

// Returns in a fan ahead, 20 to 60 m away, in FLU.
std::vector<Eigen::Vector3d> Fan() {
  std::vector<Eigen::Vector3d> fan;
  for (int i = -10; i <= 10; ++i) fan.emplace_back(40.0 + i, 2.0 * i, 0.1 * i);
  return fan;
}

std::vector<Eigen::Vector3d> RightDownForward(const std::vector<Eigen::Vector3d>& flu) {
  std::vector<Eigen::Vector3d> rdf;
  for (const Eigen::Vector3d& p : flu) rdf.emplace_back(-p.y(), -p.z(), p.x());
  return rdf;
}

TEST(AxesSource, TurnsAsSet) {
  AxesSource source(std::make_unique<SameScans>(RightDownForward(Fan()), 2), "rdf");
  for (const RadarScan& scan : testing::ReadAll(&source)) {
    for (std::size_t i = 0; i < Fan().size(); ++i) {
      EXPECT_EQ(scan.returns[i].position, Fan()[i]);
      EXPECT_EQ(scan.returns[i].doppler, -3.0);
    }
  }
  EXPECT_EQ(source.Facts().axes, "+z-x-y (as set)");
}

TEST(AxesSource, AutoTellsRightDownForwardFromForwardLeftUp) {
  AxesSource flu(std::make_unique<SameScans>(Fan(), 25), "auto");
  AxesSource rdf(std::make_unique<SameScans>(RightDownForward(Fan()), 25), "auto");
  for (AxesSource* const source : {&flu, &rdf}) {
    const std::vector<RadarScan> scans = testing::ReadAll(source);
    ASSERT_EQ(scans.size(), 25u);
    for (int k = 0; k < 25; ++k) {
      const RadarScan& scan = scans[static_cast<std::size_t>(k)];
      EXPECT_EQ(scan.stamp_ns, k);
      EXPECT_EQ(scan.returns[20].position, Fan()[20]);
    }
  }
  EXPECT_THAT(flu.Facts().axes, HasSubstr("+x+y+z (100 % of the returns of the first 10 scans"));
  EXPECT_THAT(rdf.Facts().axes, HasSubstr("+z-x-y (48 % of the returns"));
}

// A lidar on a roof that looks all around, and a radar that sees nothing: left as they are.
TEST(AxesSource, AutoLeavesWhatIsNotClear) {
  std::vector<Eigen::Vector3d> around;
  for (int i = 0; i < 60; ++i)
    around.emplace_back(20 * std::cos(0.1 * i), 20 * std::sin(0.1 * i), 2);
  for (const auto& positions : {around, std::vector<Eigen::Vector3d>()}) {
    AxesSource source(std::make_unique<SameScans>(positions, 3), "auto");
    testing::ReadAll(&source);
    EXPECT_THAT(source.Facts().axes, HasSubstr("+x+y+z"));
  }
}

TEST(AxesSource, SkipsBeforeAndAfterDeciding) {
  AxesSource source(std::make_unique<SameScans>(RightDownForward(Fan()), 30), "auto");
  RadarScan scan;
  EXPECT_EQ(source.Skip(5), ScanSource::Status::kScan);
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 5);
  EXPECT_EQ(scan.returns[20].position, Fan()[20]);
  EXPECT_EQ(source.Skip(14), ScanSource::Status::kScan);
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 20);
  EXPECT_EQ(source.Skip(10), ScanSource::Status::kEnd);
}

}  // namespace
}  // namespace radive
