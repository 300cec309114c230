// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// One drive in every container and compression comes back as it was.

#include <gtest/gtest.h>
#include <zstd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "radive/io/open/open_scan_source.h"
#include "tests/io/bags/bag_files.h"
#include "tests/io/scan_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::BagForm;
using testing::ScratchFolder;

InputOptions OptionsFor(BagFormat format) {
  InputOptions options;
  options.format = format == BagFormat::kRosbag1   ? InputOptions::Format::kRosbag1
                   : format == BagFormat::kRosbag2 ? InputOptions::Format::kRosbag2
                                                   : InputOptions::Format::kMcap;
  return options;
}

class BagRoundTrip : public ::testing::TestWithParam<BagForm> {};

TEST_P(BagRoundTrip, GivesTheSameScans) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / GetParam().name;
  const std::vector<RadarScan> scans = testing::MadeScans(20);
  testing::WriteBag(path, GetParam(), scans);
  std::string error;
  const auto source = OpenScanSource(path.string(), OptionsFor(GetParam().format), &error);
  ASSERT_NE(source, nullptr) << error;
  EXPECT_EQ(source->NumScans(), 20);
  const std::vector<RadarScan> read = testing::ReadAll(source.get());
  testing::ExpectSameScans(read, scans);
  EXPECT_TRUE(read.front().has_doppler);
  EXPECT_FALSE(read.front().is_planar);
  // What a bag without an index says of itself is no reason to doubt its scans.
  EXPECT_EQ(source->TakeWarnings().size(),
            GetParam().index || GetParam().format == BagFormat::kRosbag2 ? 0u : 1u);
}

TEST_P(BagRoundTrip, SkippedScansAreThoseThatNextWouldHaveGiven) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / GetParam().name;
  const std::vector<RadarScan> scans = testing::MadeScans(20);
  testing::WriteBag(path, GetParam(), scans);
  std::string error;
  const auto source = OpenScanSource(path.string(), OptionsFor(GetParam().format), &error);
  ASSERT_NE(source, nullptr) << error;
  EXPECT_EQ(source->Skip(13), ScanSource::Status::kScan);
  testing::ExpectSameScans(testing::ReadAll(source.get()), {scans.begin() + 13, scans.end()});
  EXPECT_EQ(source->Skip(1), ScanSource::Status::kEnd);
}

TEST_P(BagRoundTrip, EachTopicCanBeReadAloneOrWithTheOthers) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / GetParam().name;
  testing::WriteBag(path, GetParam(), testing::MadeScans(20));
  std::string error;
  const auto open = [&] { return OpenMessageSource(path, GetParam().format, {}, &error); };
  auto bag = open();
  ASSERT_NE(bag, nullptr) << error;
  ASSERT_EQ(bag->topics().size(), 2u);
  EXPECT_EQ(bag->topics()[0].num_messages, 20u);
  EXPECT_EQ(bag->topics()[1].num_messages, 20u);
  const auto all = testing::ReadMessages(bag.get());
  ASSERT_EQ(all.size(), 40u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].topic, i % 2 == 0 ? "/imu" : "/radar");
    EXPECT_EQ(all[i].record_ns,
              static_cast<std::int64_t>(i / 2) * 100000000 + (i % 2 == 0 ? 1000000 : 5000000));
  }
  EXPECT_EQ(all[4].payload, std::string(300, 'i'));
  bag = open();
  const auto imu = testing::ReadMessages(bag.get(), {"/imu"});
  ASSERT_EQ(imu.size(), 20u);
  EXPECT_EQ(imu[3], all[6]);
}

INSTANTIATE_TEST_SUITE_P(AllForms,
                         BagRoundTrip,
                         ::testing::ValuesIn(testing::AllBagForms()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

// compression_mode FILE: the whole .db3 or .mcap is a zstd file.
TEST(PackedBag, IsUnpackedBehindTheScenes) {
  for (const BagForm& form :
       {BagForm{"sqlite", BagFormat::kRosbag2}, BagForm{"part.mcap", BagFormat::kMcap}}) {
    const ScratchFolder folder;
    const std::vector<RadarScan> scans = testing::MadeScans(6);
    const bool is_mcap = form.format == BagFormat::kMcap;
    testing::WriteBag(folder.path() / form.name, form, scans);
    const std::filesystem::path plain =
        is_mcap ? folder.path() / form.name : folder.path() / form.name / "sqlite_0.db3";
    std::filesystem::create_directory(folder.path() / "packed");
    const std::string content = testing::ReadFile(plain);
    std::ofstream(folder.path() / "packed" / "part.zstd", std::ios::binary)
        << Compress(Compression::kZstd, content);
    std::ofstream(folder.path() / "packed" / "metadata.yaml")
        << "rosbag2_bagfile_information:\n  version: 4\n  storage_identifier: "
        << (is_mcap ? "mcap" : "sqlite3")
        << "\n  relative_file_paths:\n    - bag/part.zstd\n  compression_format: zstd\n"
           "  compression_mode: FILE\n";
    std::string error;
    const auto source =
        BagSource::Open(folder.path() / "packed", BagFormat::kRosbag2, InputOptions(), &error);
    ASSERT_NE(source, nullptr) << error;
    testing::ExpectSameScans(testing::ReadAll(source.get()), scans);
  }
}

// compression_mode MESSAGE in an MCAP file, and without the metadata.yaml that says so.
TEST(PackedBag, PayloadsAreKnownToBePackedByThemselves) {
  const ScratchFolder folder;
  const BagForm form = {"bag.mcap", BagFormat::kMcap};
  const std::vector<RadarScan> scans = testing::MadeScans(6);
  const auto writer = testing::OpenWriter(folder.path() / form.name, form);
  const int topic = writer->AddTopic(testing::CloudTopic(form));
  std::string error;
  for (const RadarScan& scan : scans) {
    const std::string payload = EncodePointCloud2(scan, "cdr", "radar");
    ASSERT_TRUE(writer->Write(topic, scan.stamp_ns, Compress(Compression::kZstd, payload), &error));
  }
  ASSERT_TRUE(writer->Close(&error));
  const auto source =
      BagSource::Open(folder.path() / form.name, form.format, InputOptions(), &error);
  ASSERT_NE(source, nullptr) << error;
  testing::ExpectSameScans(testing::ReadAll(source.get()), scans);
}

}  // namespace
}  // namespace radive
