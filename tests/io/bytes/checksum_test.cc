// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/checksum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/bags/mcap_reader.h"
#include "tests/io/bags/bag_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::BagForm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The check value of the CRC-32 that MCAP means (as in zlib, PNG and Ethernet).
TEST(Crc32, HasItsCheckValue) {
  EXPECT_EQ(Crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(Crc32("6789", Crc32("12345")), 0xCBF43926u);
  EXPECT_EQ(Crc32(""), 0u);
  const std::string many(3000000, 'x');
  MemoryFile file("many", many);
  EXPECT_EQ(Crc32(&file), Crc32(many));
}

// An MCAP file of 8 clouds of 1 kB, two a chunk or less, each with a message of another topic and
// of that size beside it.
std::string WriteMcap(Compression compression, std::size_t other_size) {
  const testing::ScratchFolder folder;
  const BagForm form = {"a.mcap", BagFormat::kMcap, compression, true, 2000};
  const auto writer = testing::OpenWriter(folder.path() / form.name, form);
  const int clouds = writer->AddTopic(testing::CloudTopic(form));
  const int others = writer->AddTopic({"/imu", "sensor_msgs/msg/Imu", "cdr", {}});
  std::string error;
  for (int k = 0; k < 8; ++k) {
    const std::string payload = "cloud" + std::to_string(k) + std::string(1000, 'c');
    EXPECT_TRUE(writer->Write(clouds, 10 * k, payload, &error)) << error;
    EXPECT_TRUE(writer->Write(others, 10 * k + 1, std::string(other_size, 'i'), &error)) << error;
  }
  EXPECT_TRUE(writer->Close(&error)) << error;
  return testing::ReadFile(folder.path() / form.name);
}

struct Outcome {
  std::vector<std::string> clouds;  // their first six bytes
  std::vector<std::string> warnings;
};

Outcome Read(const std::string& bytes) {
  std::string error;
  const auto bag = McapReader::Open(std::make_unique<MemoryFile>("bag", bytes), {}, &error);
  Outcome outcome;
  if (bag == nullptr) {
    ADD_FAILURE() << error;
    return outcome;
  }
  for (const auto& message : testing::ReadMessages(bag.get(), {"/radar"})) {
    outcome.clouds.push_back(message.payload.substr(0, 6));
  }
  outcome.warnings = bag->TakeWarnings();
  return outcome;
}

// Turns one byte of the text into another.
std::string Spoilt(std::string bytes, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    const std::size_t place = bytes.find(text);
    EXPECT_NE(place, std::string::npos) << text;
    if (place != std::string::npos) bytes[place] = '#';
  }
  return bytes;
}

TEST(McapChecksums, AreRightInWhatIsWritten) {
  for (const Compression compression :
       {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    const Outcome outcome = Read(WriteMcap(compression, 1));
    EXPECT_EQ(outcome.clouds.size(), 8u);
    EXPECT_THAT(outcome.warnings, IsEmpty());
  }
}

TEST(McapChecksums, ASpoiltChunkIsReadWithACountedWarning) {
  const Outcome outcome = Read(Spoilt(WriteMcap(Compression::kNone, 1), {"cloud2", "cloud6"}));
  EXPECT_THAT(
      outcome.clouds,
      ElementsAre("cloud0", "cloud1", "#loud2", "cloud3", "cloud4", "cloud5", "#loud6", "cloud7"));
  EXPECT_THAT(outcome.warnings,
              ElementsAre(HasSubstr("is not what its checksum says; it is read all the same"),
                          HasSubstr("and 1 more: chunks with a wrong checksum")));
}

// The checksum of the first chunk stands 9 + 24 bytes behind the start of its record, which follows
// the header.
TEST(McapChecksums, OfPackedChunksAreLookedAt) {
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    std::string bytes = WriteMcap(compression, 1);
    const std::size_t header = 8 + 9 + 4 + 4 + 4 + 6;  // magic, record, "ros2", "radive"
    ASSERT_EQ(bytes[header], 6) << "a chunk";
    bytes[header + 9 + 24] = static_cast<char>(bytes[header + 9 + 24] ^ 1);
    const Outcome outcome = Read(bytes);
    EXPECT_EQ(outcome.clouds.size(), 8u);
    EXPECT_THAT(outcome.warnings, ElementsAre(HasSubstr("is not what its checksum says")));
  }
}

// Out of chunks full of other things only the clouds are read.
TEST(McapChecksums, OfPlainChunksNeedMostOfTheBytes) {
  EXPECT_THAT(Read(Spoilt(WriteMcap(Compression::kNone, 2000), {"cloud2"})).warnings, IsEmpty());
}

TEST(McapChecksums, WithASpoiltSummaryTheFileIsWalkedThrough) {
  std::string bytes = WriteMcap(Compression::kNone, 1);
  // The last of the counts of the statistics, in front of the footer.
  const std::size_t place = bytes.size() - 8 - 29 - 1;
  bytes[place] = static_cast<char>(bytes[place] ^ 1);
  const Outcome outcome = Read(bytes);
  EXPECT_EQ(outcome.clouds.size(), 8u);
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_THAT(outcome.warnings[0],
              HasSubstr("the summary is not what its checksum says: read from the start"));
}

}  // namespace
}  // namespace radive
