// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/raflow_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/datasets/raflow_json.h"
#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TempFolder;

// One point at x with Doppler -x.
std::string Scan(int x) {
  const std::string value = std::to_string(x);
  return "{\"car_loc_x\":[" + value + "],\"car_loc_y\":[2.5],\"car_loc_z\":[3],\"car_vel_r\":[-" +
         value + "],\"rcs\":[7],\"power\":[20],\"pose\":[[1]]}";
}

std::string Pair(int first, int second) {
  return "{\"pc1\":" + Scan(first) + ",\"pc2\":" + Scan(second) + ",\"interval\":0.1}";
}

std::string Name(int sequence, int sample) {
  return "train/radar_seqs-" + std::to_string(sequence) + "_samples-" + std::to_string(sample) +
         ".json";
}

class RaFlowSourceTest : public ::testing::Test {
 protected:
  std::unique_ptr<RaFlowSource> Open() {
    return RaFlowSource::Open(folder_.path(), options_, &error_);
  }

  TempFolder folder_;
  InputOptions options_;
  std::string error_;
};

// Samples 9, 10, 11 follow one another; 12 does not go on where 11 ends; 14 is alone.
TEST_F(RaFlowSourceTest, ConsecutiveSamplesAreOneDrive) {
  folder_.Write(Name(0, 9), Pair(1, 2));
  folder_.Write(Name(0, 10), Pair(2, 3));
  folder_.Write(Name(0, 11), Pair(3, 4));
  folder_.Write(Name(0, 12), Pair(50, 51));
  folder_.Write(Name(0, 14), Pair(60, 61));
  folder_.Write(Name(1, 12), Pair(4, 5));
  const auto longest = Open();
  ASSERT_NE(longest, nullptr) << error_;
  EXPECT_EQ(longest->NumScans(), 4);
  EXPECT_THAT(longest->Description(), HasSubstr("clip 1 of 4 (input.clip), samples 9 to 11"));
  const auto scans = testing::ReadAll(longest.get());
  EXPECT_THAT(testing::FirstX(scans), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(testing::Stamps(scans), ElementsAre(0, 100000000, 200000000, 300000000));
  EXPECT_EQ(scans[1].returns[0].position, Eigen::Vector3d(2, 2.5, 3));
  EXPECT_EQ(scans[1].returns[0].doppler, -2.0);
  EXPECT_EQ(scans[1].returns[0].power, 20.0);
  EXPECT_TRUE(scans[1].has_doppler);

  options_.clip = 3;
  EXPECT_THAT(testing::FirstX(testing::ReadAll(Open().get())), ElementsAre(60, 61));
  options_.clip = 5;
  EXPECT_EQ(Open(), nullptr);
  EXPECT_THAT(error_, HasSubstr("has 4 clips of consecutive scans, there is no number 5"));
}

TEST_F(RaFlowSourceTest, SaysWhatIsWrong) {
  EXPECT_EQ(Open(), nullptr);
  EXPECT_THAT(error_, HasSubstr("expected files radar_seqs-S_samples-K.json"));
  folder_.Write(Name(0, 1), "{\"pc1\":" + Scan(1) + "}");
  EXPECT_EQ(Open(), nullptr);
  EXPECT_THAT(error_, HasSubstr("samples-1.json: interval: expected the seconds"));
}

// Every file is in one clip; the gap-free runs are those that the data's own description lists.
TEST(RaFlowSource, ClipsOfTheRealData) {
  RADIVE_SKIP_WITHOUT("raflow-inhouse");
  std::string error;
  std::string all;
  int num_pairs = 0;
  InputOptions options;
  for (options.clip = 1; options.clip <= 30; ++options.clip) {
    const auto source =
        RaFlowSource::Open(testing::SharedData() / "raflow-inhouse", options, &error);
    ASSERT_NE(source, nullptr) << error;
    const auto scans = testing::ReadAll(source.get());
    num_pairs += static_cast<int>(scans.size()) - 1;
    for (const RadarScan& scan : scans) EXPECT_GT(scan.returns.size(), 200u);
    all += source->Description() + "\n";
  }
  EXPECT_EQ(num_pairs, 90);
  for (const char* clip : {"samples 6 to 17 of sequence 0",
                           "samples 622 to 626 of sequence 1",
                           "samples 1986 to 1991 of sequence 2",
                           "samples 10 to 20 of sequence 0"}) {
    EXPECT_THAT(all, HasSubstr(clip));
  }
}

TEST(ParseRaFlowPair, SaysWhatIsWrong) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "expected a JSON object"},
      {"[1,2]", "expected a JSON object"},
      {Pair(1, 2).substr(0, 60), "expected a JSON object"},
      {"{\"interval\":0.1}", "pc1.car_loc_x: expected a list of numbers"},
      {"{\"pc1\":[1],\"interval\":0.1}", "pc1.car_loc_x"},
      {"{\"pc1\":{\"car_loc_x\":[1],\"car_loc_y\":[1,2]},\"interval\":0.1}", "pc1.car_loc_y"},
      {"{\"pc1\":{\"car_loc_x\":[\"1\"]},\"interval\":0.1}", "pc1.car_loc_x"},
      {"{\"pc1\":" + Scan(1) + ",\"interval\":-1}", "interval"},
  };
  for (const auto& [text, message] : cases) {
    RaFlowPair pair;
    std::string error;
    EXPECT_FALSE(ParseRaFlowPair(text, &pair, &error)) << text;
    EXPECT_THAT(error, HasSubstr(message));
  }
}

TEST(ParseRaFlowName, TakesNothingElse) {
  std::int64_t sequence = 0, sample = 0;
  EXPECT_TRUE(ParseRaFlowName("radar_seqs-3_samples-0618.json", &sequence, &sample));
  EXPECT_EQ(sequence, 3);
  EXPECT_EQ(sample, 618);
  for (const char* name : {"",
                           "radar_seqs-_samples-1.json",
                           "radar_seqs-1_samples-.json",
                           "radar_seqs-1_samples-1.jsonl",
                           "radar_seqs-1.json",
                           "radar_seqs-1_samples--1.json",
                           "lidar_seqs-1_samples-1.json"}) {
    EXPECT_FALSE(ParseRaFlowName(name, &sequence, &sample)) << name;
  }
}

}  // namespace
}  // namespace radive
