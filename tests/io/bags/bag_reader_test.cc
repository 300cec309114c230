// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// What the readers of the containers do beyond the round trip: order, splits, breaks, refusals.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/bags/mcap_reader.h"
#include "radive/io/bags/open_bag_file.h"
#include "radive/io/bags/open_message_source.h"
#include "radive/io/bags/ros1_bag_reader.h"
#include "radive/io/bags/rosbag2_folder.h"
#include "radive/io/bags/sqlite_bag_reader.h"
#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/compression.h"
#include "radive/io/bytes/record_file.h"
#include "tests/io/bags/bag_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::AllOf;
using testing::BagForm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ReadMessages;
using testing::ScratchFolder;

std::vector<std::int64_t> Times(const std::vector<testing::ReadMessage>& messages) {
  std::vector<std::int64_t> times;
  for (const auto& message : messages) times.push_back(message.record_ns);
  return times;
}

// Messages "m<time>" at these times, padded so that two or three fill a chunk of 1000 bytes.
void WriteTimes(const std::filesystem::path& path,
                const BagForm& form,
                const std::vector<std::int64_t>& times_ns) {
  const auto writer = testing::OpenWriter(path, form);
  const int topic = writer->AddTopic(testing::CloudTopic(form));
  std::string error;
  for (const std::int64_t time_ns : times_ns) {
    const std::string payload = "m" + std::to_string(time_ns) + std::string(400, '.');
    ASSERT_TRUE(writer->Write(topic, time_ns, payload, &error)) << error;
  }
  ASSERT_TRUE(writer->Close(&error)) << error;
}

std::unique_ptr<MessageSource> OpenFile(const std::filesystem::path& path,
                                        BagFormat format,
                                        const MessageLimits& limits = {}) {
  std::string error;
  auto source = OpenMessageSource(path, format, limits, &error);
  EXPECT_NE(source, nullptr) << error;
  return source;
}

std::string ErrorOf(const std::filesystem::path& path, BagFormat format) {
  std::string error;
  EXPECT_EQ(OpenMessageSource(path, format, {}, &error), nullptr);
  EXPECT_THAT(error, HasSubstr(path.string()));
  return error;
}

void WriteText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// Two recorders into one file, one of them late: chunks overlap in time.
TEST(BagReader, OverlappingChunksAreMerged) {
  for (const BagForm& form : testing::AllBagForms()) {
    SCOPED_TRACE(form.name);
    const ScratchFolder folder;
    WriteTimes(folder.path() / form.name, form, {10, 20, 30, 70, 80, 15, 25, 26, 75, 76, 5, 90});
    const auto messages = ReadMessages(OpenFile(folder.path() / form.name, form.format).get());
    EXPECT_THAT(Times(messages), ElementsAre(5, 10, 15, 20, 25, 26, 30, 70, 75, 76, 80, 90));
    for (const auto& message : messages) {
      EXPECT_EQ(message.payload.substr(0, message.payload.find('.')),
                "m" + std::to_string(message.record_ns));
    }
  }
}

// NAME_2 comes before NAME_10; the files overlap a little, and messages of the same time keep the
// order of the files.
TEST(BagReader, FilesOfASplitBagAreOneStream) {
  for (const BagForm& form : {BagForm{".bag", BagFormat::kRosbag1}, {".mcap", BagFormat::kMcap}}) {
    const ScratchFolder folder;
    WriteTimes(folder.path() / ("a_10" + form.name), form, {40, 50, 60});
    WriteTimes(folder.path() / ("a_2" + form.name), form, {10, 20, 30, 40, 45});
    const auto source = OpenFile(folder.path(), form.format);
    ASSERT_EQ(source->topics().size(), 1u);
    EXPECT_EQ(source->topics()[0].num_messages, 8u);
    EXPECT_THAT(Times(ReadMessages(source.get())), ElementsAre(10, 20, 30, 40, 40, 45, 50, 60));
    EXPECT_EQ(source->Description(), "2 bag files in " + folder.path().string());
  }
}

// A recording that was cut off is read up to the break.
TEST(BagReader, WhatIsInFrontOfABreakIsRead) {
  for (const BagForm& form : testing::AllBagForms()) {
    if (form.format == BagFormat::kRosbag2) continue;
    SCOPED_TRACE(form.name);
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / form.name;
    std::vector<std::int64_t> times;
    for (int k = 0; k < 30; ++k) times.push_back(10 * k);
    WriteTimes(path, form, times);
    const std::string whole = testing::ReadFile(path);
    std::size_t most = 0;
    for (std::size_t size = whole.size() - 1; size > whole.size() / 4; size -= 97) {
      std::filesystem::resize_file(path, size);
      const auto source = OpenFile(path, form.format);
      const std::vector<std::int64_t> read = Times(ReadMessages(source.get()));
      ASSERT_LE(read.size(), times.size());
      EXPECT_TRUE(std::equal(read.begin(), read.end(), times.begin())) << size;
      most = std::max(most, read.size());
      if (read.size() < times.size()) {
        std::string warnings;
        for (const std::string& warning : source->TakeWarnings()) warnings += warning + "\n";
        EXPECT_THAT(warnings, AllOf(HasSubstr(path.string()), HasSubstr("at byte "))) << size;
      }
    }
    EXPECT_GE(most, 27u);
    // Half of the messages are in the first half of a file that is not packed.
    if (form.compression == Compression::kNone) {
      const std::size_t start = form.format == BagFormat::kRosbag1 ? 4117 : 100;
      WriteText(path, whole.substr(0, start + (whole.size() - start) / 2));
      const auto read = ReadMessages(OpenFile(path, form.format).get());
      EXPECT_GE(read.size(), 12u);
      EXPECT_LE(read.size(), 18u);
    }
  }
}

// Counts what is read of a file.
class CountingFile : public RandomAccessFile {
 public:
  CountingFile(std::string bytes, std::uint64_t* count)
      : RandomAccessFile("counted", bytes.size()), bytes_(std::move(bytes)), count_(count) {}
  std::optional<std::string_view> Read(std::uint64_t position,
                                       std::uint64_t count,
                                       std::string*) override {
    if (!Contains(position, count)) return std::nullopt;
    *count_ += count;
    return std::string_view(bytes_).substr(position, count);
  }

 private:
  const std::string bytes_;
  std::uint64_t* const count_;
};

TEST(BagReader, ImagesAreNotReadForTheRadarBetweenThem) {
  for (const BagForm& form :
       {BagForm{"a.bag", BagFormat::kRosbag1}, BagForm{"a.mcap", BagFormat::kMcap}}) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / form.name;
    const auto writer = testing::OpenWriter(path, form);
    const int radar = writer->AddTopic(testing::CloudTopic(form));
    const int camera = writer->AddTopic({"/camera", "sensor_msgs/Image", "ros1", {}});
    std::string error;
    for (int k = 0; k < 20; ++k) {
      writer->Write(radar, k, std::string(500, 'r'), &error);
      writer->Write(camera, k, std::string(100000, 'c'), &error);
    }
    ASSERT_TRUE(writer->Close(&error));
    std::uint64_t count = 0;
    auto file = std::make_unique<CountingFile>(testing::ReadFile(path), &count);
    std::unique_ptr<MessageSource> source;
    if (form.format == BagFormat::kRosbag1) {
      source = Ros1BagReader::Open(std::move(file), {}, &error);
    } else {
      source = McapReader::Open(std::move(file), {}, &error);
    }
    ASSERT_NE(source, nullptr) << error;
    EXPECT_EQ(ReadMessages(source.get(), {"/radar"}).size(), 20u);
    EXPECT_LT(count, 40000u) << "of 2 MB";
  }
}

TEST(BagReader, AMessageBeyondTheLimitIsAnErrorThatNamesTheSetting) {
  for (const BagForm& form : testing::AllBagForms()) {
    const ScratchFolder folder;
    WriteTimes(folder.path() / form.name, form, {10, 20});
    MessageLimits limits;
    limits.message = 300;
    const auto source = OpenFile(folder.path() / form.name, form.format, limits);
    source->Select({0});
    Message message;
    const MessageSource::Status status = source->Next(&message);
    // A payload that is packed on its own is just as damaged as one that is too large.
    if (form.format == BagFormat::kRosbag2 && form.compression == Compression::kZstd) continue;
    EXPECT_EQ(status, MessageSource::Status::kError) << form.name;
    EXPECT_THAT(source->error(), HasSubstr("input.max_message_bytes")) << form.name;
  }
}

TEST(BagReader, OtherFilesAreRefused) {
  const ScratchFolder folder;
  WriteText(folder.path() / "text.bag", "hello");
  EXPECT_THAT(ErrorOf(folder.path() / "text.bag", BagFormat::kRosbag1), HasSubstr("neither"));
  WriteText(folder.path() / "empty.bag", "");
  EXPECT_THAT(ErrorOf(folder.path() / "empty.bag", BagFormat::kRosbag1), HasSubstr("empty"));
  WriteText(folder.path() / "old.bag", "#ROSBAG V1.2\nwhatever");
  EXPECT_THAT(ErrorOf(folder.path() / "old.bag", BagFormat::kRosbag1), HasSubstr("V2.0"));
  WriteText(folder.path() / "lfs.mcap", "version https://git-lfs.github.com/spec/v1\n");
  EXPECT_THAT(ErrorOf(folder.path() / "lfs.mcap", BagFormat::kMcap), HasSubstr("Git-LFS"));
  EXPECT_THAT(ErrorOf(folder.path() / "absent", BagFormat::kMcap), HasSubstr("does not exist"));
  std::filesystem::create_directory(folder.path() / "none");
  EXPECT_THAT(ErrorOf(folder.path() / "none", BagFormat::kRosbag2),
              AllOf(HasSubstr("*.db3"), HasSubstr("metadata.yaml")));
}

TEST(Ros1BagReader, FieldsMayHaveAnyOrderAndATopicSeveralConnections) {
  const auto u32 = [](std::uint32_t value) {
    std::string bytes;
    AppendLittleEndian(value, &bytes);
    return bytes;
  };
  const auto sized = [&](const std::string& bytes) {
    return u32(static_cast<std::uint32_t>(bytes.size())) + bytes;
  };
  const auto field = [&](const std::string& text) { return sized(text); };
  const auto connection = [&](std::uint32_t number) {
    return sized(field("topic=/a") + field("conn=" + u32(number)) + field("op=\x07")) +
           sized(field("callerid=/x=y") + field("type=b/C"));
  };
  const auto message = [&](std::uint32_t number, std::uint32_t seconds, const std::string& data) {
    return sized(field("time=" + u32(seconds) + u32(1)) + field("unknown=") +
                 field("conn=" + u32(number)) + field("op=\x02")) +
           sized(data);
  };
  // No chunks at all.
  const std::string bag = "#ROSBAG V2.0\n" + connection(7) + connection(3) + message(3, 2, "two") +
                          message(7, 1, "one") + message(5, 1, "of nobody");
  std::string error;
  const auto reader = Ros1BagReader::Open(std::make_unique<MemoryFile>("bag", bag), {}, &error);
  ASSERT_NE(reader, nullptr) << error;
  ASSERT_EQ(reader->topics().size(), 1u);
  EXPECT_EQ(reader->topics()[0].type, "b/C");
  EXPECT_EQ(reader->topics()[0].num_messages, 2u);
  EXPECT_EQ(reader->start_ns(), 1000000001);
  const auto messages = ReadMessages(reader.get());
  EXPECT_THAT(Times(messages), ElementsAre(1000000001, 2000000001));
  EXPECT_EQ(messages[0].payload, "one");
}

TEST(Ros1BagReader, AnEncryptedBagIsRefused) {
  const std::string header =
      std::string("\4\0\0\0op=\3", 8) + std::string("\x10\0\0\0encryptor=a/Bcde", 20);
  std::string bag = "#ROSBAG V2.0\n";
  AppendLittleEndian(static_cast<std::uint32_t>(header.size()), &bag);
  bag += header + std::string(4, '\0');
  std::string error;
  EXPECT_EQ(Ros1BagReader::Open(std::make_unique<MemoryFile>("bag", bag), {}, &error), nullptr);
  EXPECT_THAT(error, HasSubstr("encrypted ('a/Bcde')"));
}

TEST(Ros1BagReader, ADamagedIndexIsNotNeeded) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "a.bag";
  WriteTimes(path, {"a.bag", BagFormat::kRosbag1, Compression::kLz4}, {10, 20, 30, 40, 50});
  std::string bytes = testing::ReadFile(path);
  bytes[bytes.rfind("chunk_pos=") + 12] ^= 1;  // the last chunk is said to be elsewhere
  WriteText(path, bytes);
  const auto source = OpenFile(path, BagFormat::kRosbag1);
  EXPECT_THAT(source->TakeWarnings(), ElementsAre(HasSubstr("read from the start to the end")));
  EXPECT_THAT(Times(ReadMessages(source.get())), ElementsAre(10, 20, 30, 40, 50));
}

// Recorders may write messages without any chunk, and of ROS 1.
TEST(McapReader, MessagesMayLieOutsideOfChunks) {
  const auto record = [](char opcode, const std::string& data) {
    std::string bytes(1, opcode);
    AppendLittleEndian(static_cast<std::uint64_t>(data.size()), &bytes);
    return bytes + data;
  };
  const std::string magic("\x89MCAP0\r\n", 8);
  const std::string schema("\5\0\1\0\0\0T\0\0\0\0\0\0\0\0", 15);
  const std::string channel("\2\0\5\0\2\0\0\0/a\4\0\0\0ros1\0\0\0\0", 22);
  const auto message = [&](char time, const std::string& data) {
    return record('\5', std::string("\2\0\0\0\0\0", 6) + time + std::string(15, '\0') + data);
  };
  const std::string file = magic + record('\3', schema) + record('\4', channel) +
                           message(9, "nine") + message(4, "four") + record('\x0F', "1234") +
                           record('\2', std::string(20, '\0')) + magic;
  std::string error;
  const auto reader = McapReader::Open(std::make_unique<MemoryFile>("bag", file), {}, &error);
  ASSERT_NE(reader, nullptr) << error;
  ASSERT_EQ(reader->topics().size(), 1u);
  EXPECT_EQ(reader->topics()[0].name, "/a");
  EXPECT_EQ(reader->topics()[0].type, "T");
  EXPECT_EQ(reader->topics()[0].encoding, "ros1");
  const auto messages = ReadMessages(reader.get());
  EXPECT_THAT(Times(messages), ElementsAre(4, 9));
  EXPECT_EQ(messages[1].payload, "nine");
}

// A whole file of two messages without chunks, whose summary counts `counted` of them.
std::string UnchunkedFile(std::uint64_t counted) {
  const auto sized = [](const std::string& text) {
    return LittleEndian(static_cast<std::uint32_t>(text.size())) + text;
  };
  const auto record = [](char opcode, const std::string& data) {
    return opcode + LittleEndian(static_cast<std::uint64_t>(data.size())) + data;
  };
  const auto message = [&](std::uint64_t time, const std::string& data) {
    return record(5,
                  LittleEndian(std::uint16_t{2}) + LittleEndian(std::uint32_t{0}) +
                      LittleEndian(time) + LittleEndian(time) + data);
  };
  const std::string magic("\x89MCAP0\r\n", 8);
  const std::string definitions =
      record(3, LittleEndian(std::uint16_t{5}) + sized("T") + sized("") + sized("")) +
      record(4,
             LittleEndian(std::uint16_t{2}) + LittleEndian(std::uint16_t{5}) + sized("/a") +
                 sized("cdr") + sized(""));
  // Counts of schemas, channels, attachments, metadata and chunks; first and last time; the
  // messages of each channel.
  const std::string statistics =
      record(11,
             LittleEndian(counted) + LittleEndian(std::uint16_t{1}) +
                 LittleEndian(std::uint32_t{1}) + std::string(12, '\0') + std::string(16, '\0') +
                 sized(LittleEndian(std::uint16_t{2}) + LittleEndian(counted)));
  const std::string data = magic + record(0x01, sized("") + sized("")) + definitions +
                           message(4, "four") + message(9, "nine") +
                           record(15, std::string(4, '\0'));
  return data + definitions + statistics +
         record(2, LittleEndian(static_cast<std::uint64_t>(data.size())) + std::string(12, '\0')) +
         magic;
}

// Not to be taken for a file without its index.
TEST(McapReader, AFileWithoutChunksIsSound) {
  std::string error;
  auto reader =
      McapReader::Open(std::make_unique<MemoryFile>("a.mcap", UnchunkedFile(2)), {}, &error);
  ASSERT_NE(reader, nullptr) << error;
  EXPECT_EQ(reader->Description(), "MCAP file a.mcap (without chunks)");
  EXPECT_THAT(Times(ReadMessages(reader.get())), ElementsAre(4, 9));
  EXPECT_THAT(reader->TakeWarnings(), ::testing::IsEmpty());
  reader = McapReader::Open(std::make_unique<MemoryFile>("a.mcap", UnchunkedFile(3)), {}, &error);
  ASSERT_NE(reader, nullptr) << error;
  EXPECT_THAT(reader->TakeWarnings(),
              ElementsAre(HasSubstr("the summary counts 3 messages, the file holds 2")));
}

TEST(McapReader, AnUnknownCompressionIsNamed) {
  const ScratchFolder folder;
  for (const bool index : {true, false}) {
    const std::filesystem::path path = folder.path() / "a.mcap";
    WriteTimes(path, {"a.mcap", BagFormat::kMcap, Compression::kLz4, index}, {10, 20, 30});
    std::string bytes = testing::ReadFile(path);
    const std::string name("\3\0\0\0lz4", 7);
    for (std::size_t at = 0; (at = bytes.find(name, at)) != std::string::npos; ++at) {
      bytes.replace(at + 4, 3, "xyz");
    }
    WriteText(path, bytes);
    EXPECT_THAT(
        ErrorOf(path, BagFormat::kMcap),
        AllOf(HasSubstr("a.mcap"), HasSubstr("compression 'xyz', expected none, lz4 or zstd")));
  }
}

void RunSql(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
}

// Other releases have other columns, in another order, and a copy may have lost its index.
TEST(SqliteBagReader, ColumnsAreFoundByName) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "what?#%41.db3";
  RunSql(path,
         "CREATE TABLE topics(hash TEXT, type TEXT, name TEXT, id INTEGER, "
         "serialization_format TEXT);"
         "INSERT INTO topics VALUES ('h', 'b/msg/C', '/a', 42, 'cdr');"
         "CREATE TABLE messages(data BLOB, timestamp INTEGER, topic_id INTEGER);"
         "INSERT INTO messages VALUES (x'6c61746572', 20, 42), (x'6561726c79', 10, 42), "
         "(x'00', 5, 99), (17, 15, 42)");
  const auto source = OpenFile(path, BagFormat::kRosbag2);
  ASSERT_EQ(source->topics().size(), 1u);
  EXPECT_EQ(source->topics()[0].type, "b/msg/C");
  EXPECT_EQ(source->topics()[0].num_messages, 3u);
  const auto messages = ReadMessages(source.get());
  EXPECT_THAT(Times(messages), ElementsAre(10, 20));
  EXPECT_EQ(messages[0].payload, "early");
  EXPECT_THAT(source->TakeWarnings(), ElementsAre(HasSubstr("message 4 is damaged")));
}

TEST(SqliteBagReader, TablesThatComputeAreRefused) {
  const ScratchFolder folder;
  const std::string topics =
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format);";
  RunSql(folder.path() / "view.db3",
         topics +
             "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
             "FROM n) SELECT i AS topic_id, i AS timestamp, i AS data FROM n");
  EXPECT_THAT(ErrorOf(folder.path() / "view.db3", BagFormat::kRosbag2),
              HasSubstr("has no table 'messages'"));
  RunSql(folder.path() / "generated.db3",
         topics +
             "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, "
             "data AS (zeroblob(1000000000)))");
  EXPECT_THAT(ErrorOf(folder.path() / "generated.db3", BagFormat::kRosbag2),
              HasSubstr("has no table 'messages'"));
  RunSql(folder.path() / "other.db3", "CREATE TABLE cats(name TEXT)");
  EXPECT_THAT(ErrorOf(folder.path() / "other.db3", BagFormat::kRosbag2),
              HasSubstr("has no table 'topics', expected a rosbag 2"));
}

TEST(Rosbag2Metadata, SaysWhatItDoesNotKnow) {
  Rosbag2Metadata metadata;
  std::string error;
  const std::string start = "rosbag2_bagfile_information:\n  storage_identifier: ";
  const std::string files = "\n  relative_file_paths: [a, b]\n";
  EXPECT_TRUE(ParseRosbag2Metadata(start + "mcap" + files, &metadata, &error)) << error;
  EXPECT_TRUE(metadata.is_mcap);
  EXPECT_THAT(metadata.files, ElementsAre("a", "b"));
  EXPECT_TRUE(ParseRosbag2Metadata(
      start + "sqlite3" + files + "  compression_format: zstd\n  compression_mode: MESSAGE\n",
      &metadata,
      &error));
  EXPECT_FALSE(ParseRosbag2Metadata(start + "rocksdb" + files, &metadata, &error));
  EXPECT_THAT(error, HasSubstr("'rocksdb', expected sqlite3 or mcap"));
  EXPECT_FALSE(ParseRosbag2Metadata(
      start + "mcap" + files + "  compression_format: fake\n  compression_mode: file\n",
      &metadata,
      &error));
  EXPECT_THAT(error, HasSubstr("'fake' of 'file', expected zstd"));
  EXPECT_FALSE(ParseRosbag2Metadata(start + "mcap\n", &metadata, &error));
  EXPECT_THAT(error, HasSubstr("relative_file_paths"));
  for (const char* text : {"", "[", "1", "[1]", "a: b", "rosbag2_bagfile_information: 1"}) {
    EXPECT_FALSE(ParseRosbag2Metadata(text, &metadata, &error)) << text;
    EXPECT_NE(error, "");
  }
}

TEST(OpenBagFile, NamesOfBags) {
  EXPECT_EQ(BagFormatOfName("a.bag"), BagFormat::kRosbag1);
  EXPECT_EQ(BagFormatOfName("a.bag.active"), BagFormat::kRosbag1);
  EXPECT_EQ(BagFormatOfName("A_0.DB3"), BagFormat::kRosbag2);
  EXPECT_EQ(BagFormatOfName("a_0.db3.zstd"), BagFormat::kRosbag2);
  EXPECT_EQ(BagFormatOfName("a.mcap.zst"), BagFormat::kMcap);
  for (const char* name : {"bag", ".bag", "a.zstd", "a.bag.orig", "a.db3-wal", "a.pcd.zst"}) {
    EXPECT_FALSE(BagFormatOfName(name)) << name;
  }
}

// Each part once: unpacked or closed where it is there in both forms.
TEST(OpenBagFile, ListsEachPartOnce) {
  const ScratchFolder folder;
  for (const char* name : {"b_10.bag",
                           "b_2.bag.active",
                           "b_10.bag.active",
                           "c_1.db3.zstd",
                           "c_1.db3",
                           "c_0.db3.ZSTD",
                           "d.txt"}) {
    std::ofstream(folder.path() / name) << "x";
  }
  const auto names = [&](BagFormat format) {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> found;
    std::string error;
    EXPECT_TRUE(ListBagFiles(folder.path(), format, &files, &error)) << error;
    for (const auto& file : files) found.push_back(file.filename().string());
    return found;
  };
  EXPECT_THAT(names(BagFormat::kRosbag1), ElementsAre("b_2.bag.active", "b_10.bag"));
  EXPECT_THAT(names(BagFormat::kRosbag2), ElementsAre("c_0.db3.ZSTD", "c_1.db3"));
}

// Packed as a whole, with and without the others of its folder, and without a metadata.yaml.
TEST(OpenBagFile, PackedFilesAreUnpacked) {
  for (const BagForm& form :
       {BagForm{"a.mcap", BagFormat::kMcap}, BagForm{"a.db3", BagFormat::kRosbag2}}) {
    const ScratchFolder folder;
    const std::filesystem::path plain = folder.path() / form.name;
    WriteTimes(plain, form, {1, 2, 3});
    std::filesystem::path file = plain;
    if (std::filesystem::is_directory(plain)) {  // a rosbag 2 is written as a folder
      for (const auto& entry : std::filesystem::directory_iterator(plain)) {
        if (entry.path().extension() == ".db3") file = entry.path();
      }
    }
    std::string content, error;
    ASSERT_TRUE(ReadWholeFile(file, &content, &error)) << error;
    std::filesystem::remove_all(plain);
    const std::filesystem::path packed = plain.string() + ".zstd";
    std::ofstream(packed, std::ios::binary) << Compress(Compression::kZstd, content);
    EXPECT_THAT(Times(ReadMessages(OpenFile(packed, form.format).get())), ElementsAre(1, 2, 3));
    EXPECT_THAT(Times(ReadMessages(OpenFile(folder.path(), form.format).get())),
                ElementsAre(1, 2, 3));
    std::ofstream(folder.path() / "metadata.yaml") << "";  // of a recorder that was cut off
    EXPECT_THAT(Times(ReadMessages(OpenFile(folder.path(), form.format).get())),
                ElementsAre(1, 2, 3));
  }
}

TEST(OpenBagFile, SaysWhatArchivesAre) {
  const ScratchFolder folder;
  std::string error;
  for (const auto& [start, word] : {std::pair("\x1F\x8B\x08", "gzip"),
                                    std::pair("BZh9", "bzip2"),
                                    std::pair("PK\x03\x04", "zip"),
                                    std::pair("", "empty")}) {
    std::ofstream(folder.path() / "a.bag", std::ios::binary) << start;
    EXPECT_EQ(OpenBagFile(folder.path() / "a.bag", {}, &error), nullptr);
    EXPECT_THAT(error, AllOf(HasSubstr("a.bag: neither"), HasSubstr(word)));
  }
}

}  // namespace
}  // namespace radive
