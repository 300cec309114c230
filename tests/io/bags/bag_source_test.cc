// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radive/io/bytes/byte_order.h"
#include "tests/io/bags/bag_files.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::int64_t kSecond = 1000000000;

// A bag in memory.
class FakeBag : public MessageSource {
 public:
  explicit FakeBag(std::vector<MessageTopic> topics) { topics_ = std::move(topics); }

  void Add(int topic, std::int64_t record_ns, std::string payload) {
    messages_.push_back({topic, record_ns, std::move(payload)});
    auto& number = topics_[static_cast<std::size_t>(topic)].num_messages;
    number = number.value_or(0) + 1;
  }

  void Select(const std::vector<int>& topics) override { selected_ = topics; }
  Status Next(Message* message) override {
    while (next_ < messages_.size()) {
      const Stored& stored = messages_[next_++];
      if (std::count(selected_.begin(), selected_.end(), stored.topic) == 0) continue;
      *message = {stored.topic, stored.record_ns, stored.payload};
      return Status::kMessage;
    }
    return Status::kEnd;
  }
  std::int64_t start_ns() const override { return 0; }
  std::string Description() const override { return "fake bag"; }

 private:
  struct Stored {
    int topic;
    std::int64_t record_ns;
    std::string payload;
  };
  std::vector<Stored> messages_;
  std::vector<int> selected_;
  std::size_t next_ = 0;
};

MessageTopic Cloud(const std::string& name) {
  return {name, "sensor_msgs/PointCloud2", "ros1", {}};
}

std::string Payload(std::int64_t stamp_ns, double x = 1.0, const std::string& frame = "radar") {
  RadarScan scan;
  scan.stamp_ns = stamp_ns;
  scan.returns.resize(1);
  scan.returns[0].position = {x, 2.0, 3.0};
  scan.returns[0].doppler = -4.0;
  return EncodePointCloud2(scan, "ros1", frame);
}

// A bag with a topic of clouds that have these header stamps, recorded at 100, 101, ... s.
std::unique_ptr<FakeBag> BagWithStamps(const std::vector<std::int64_t>& stamps_ns) {
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar")});
  std::int64_t record_ns = 100 * kSecond;
  for (const std::int64_t stamp_ns : stamps_ns) {
    bag->Add(0, record_ns, Payload(stamp_ns));
    record_ns += kSecond;
  }
  return bag;
}

std::unique_ptr<BagSource> OpenFake(std::unique_ptr<FakeBag> bag,
                                    const InputOptions& options = InputOptions()) {
  std::string error;
  auto source = BagSource::Create(std::move(bag), "a.bag", options, &error);
  EXPECT_NE(source, nullptr) << error;
  return source;
}

std::string ErrorOf(std::unique_ptr<FakeBag> bag, const std::string& topic = "") {
  InputOptions options;
  options.topic = topic;
  std::string error;
  EXPECT_EQ(BagSource::Create(std::move(bag), "a.bag", options, &error), nullptr);
  return error;
}

TEST(BagSource, TakesTheOnlyTopicWithPointClouds) {
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{
      {"/imu", "sensor_msgs/Imu", "ros1", {}}, Cloud("/radar"), Cloud("/never_sent")});
  bag->Add(0, 0, "imu");
  bag->Add(1, 1, Payload(7));
  // In a bag that counts, a topic without messages is no candidate.
  bag->Add(2, 2, Payload(8));
  InputOptions options;
  options.topic = "/radar";
  const auto source = OpenFake(std::move(bag), options);
  EXPECT_EQ(source->NumScans(), 1);
  EXPECT_EQ(source->Description(), "fake bag, topic /radar (sensor_msgs/PointCloud2, 1 messages)");
  const std::vector<RadarScan> scans = testing::ReadAll(source.get());
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].stamp_ns, 7);
  EXPECT_EQ(scans[0].place, "a.bag: message 1 of /radar");
  ASSERT_EQ(scans[0].returns.size(), 1u);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scans[0].returns[0].doppler, -4.0);
  EXPECT_EQ(source->Facts().stamp_origin, "header stamps");
  EXPECT_EQ(source->Facts().fields.size(), 5u);
}

TEST(BagSource, SaysWhichTopicsThereAre) {
  const auto two = [] {
    auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{
        Cloud("/front"), {"/packets", "nebula_msgs/msg/NebulaPackets", "cdr", {}}, Cloud("/rear")});
    bag->Add(0, 0, Payload(1));
    bag->Add(1, 0, "");
    bag->Add(2, 0, Payload(1));
    return bag;
  };
  EXPECT_THAT(ErrorOf(two()),
              AllOf(HasSubstr("a.bag: has several topics"),
                    HasSubstr("input.topic"),
                    HasSubstr("/front (sensor_msgs/PointCloud2, 1 messages), /rear")));
  EXPECT_THAT(ErrorOf(two(), "/absent"),
              AllOf(HasSubstr("no topic '/absent'"), HasSubstr("/front"), HasSubstr("/packets")));
  EXPECT_THAT(ErrorOf(two(), "/packets"),
              HasSubstr("cannot read messages of /packets (nebula_msgs/msg/NebulaPackets, 1"));
  const MessageTopic tf = {"/tf", "tf2_msgs/TFMessage", "ros1", 517};
  EXPECT_THAT(
      ErrorOf(std::make_unique<FakeBag>(std::vector<MessageTopic>{tf})),
      AllOf(HasSubstr("has no point clouds"), HasSubstr("/tf (tf2_msgs/TFMessage, 517 messages)")));
  EXPECT_THAT(ErrorOf(std::make_unique<FakeBag>(std::vector<MessageTopic>{})),
              HasSubstr("no topics"));
  MessageTopic json = Cloud("/radar");
  json.encoding = "json";
  EXPECT_THAT(ErrorOf(std::make_unique<FakeBag>(std::vector<MessageTopic>{json})),
              HasSubstr("serialised as 'json'"));
}

TEST(BagSource, DopplerIsTurnedAsTheUserSays) {
  InputOptions options;
  options.doppler_sign = InputOptions::DopplerSign::kMinus;
  const auto scans = testing::ReadAll(OpenFake(BagWithStamps({5}), options).get());
  EXPECT_EQ(scans.at(0).returns.at(0).doppler, 4.0);
}

// As in the TI demo of reve: all header stamps are 0.
TEST(BagSource, TakesTheTimesOfRecordingWhereHeadersHaveNone) {
  for (const std::int64_t constant : {std::int64_t{0}, 5 * kSecond}) {
    const auto source = OpenFake(BagWithStamps(std::vector<std::int64_t>(20, constant)));
    const auto scans = testing::ReadAll(source.get());
    ASSERT_EQ(scans.size(), 20u);
    EXPECT_EQ(scans[0].stamp_ns, 100 * kSecond);
    EXPECT_EQ(scans[19].stamp_ns, 119 * kSecond);
    EXPECT_THAT(source->TakeWarnings(), ElementsAre(HasSubstr("the times of recording are taken")));
    EXPECT_EQ(source->Facts().stamp_origin, "times of recording");
  }
  EXPECT_EQ(testing::Stamps(testing::ReadAll(OpenFake(BagWithStamps({0})).get())),
            std::vector<std::int64_t>{100 * kSecond});
}

// Microseconds where nanoseconds belong: 1 kHz, but recorded with 1 Hz.
TEST(BagSource, TakesTheTimesOfRecordingWhereHeadersHaveAnotherUnit) {
  std::vector<std::int64_t> stamps;
  for (int i = 0; i < 10; ++i) stamps.push_back(7 * kSecond + i * kSecond / 1000);
  const auto source = OpenFake(BagWithStamps(stamps));
  const auto scans = testing::ReadAll(source.get());
  ASSERT_EQ(scans.size(), 10u);
  EXPECT_EQ(scans[1].stamp_ns, 101 * kSecond);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("are 0.001 s apart, but were recorded 1 s apart")));
}

TEST(BagSource, HeaderStampsMayBeginAtZero) {
  const auto source = OpenFake(BagWithStamps({0, 100, 200}));
  EXPECT_THAT(testing::Stamps(testing::ReadAll(source.get())), ElementsAre(0, 100, 200));
  EXPECT_THAT(source->TakeWarnings(), ElementsAre());
}

// OrderedSource makes an order of it.
TEST(BagSource, TellsWhenSensorsShareATopic) {
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar")});
  const char* const frames[] = {"", "front", "/front", "", "rear", "front", "rear"};
  for (int i = 0; i < 7; ++i) bag->Add(0, i * kSecond, Payload(i * kSecond, 1.0, frames[i]));
  const auto source = OpenFake(std::move(bag));
  EXPECT_EQ(testing::ReadAll(source.get()).size(), 7u);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre("a.bag: message 5 of /radar: the frame is 'rear', that of the first was "
                          "'front'; all are taken as scans of one radar",
                          "and 1 more: point clouds of another frame in a.bag"));
}

TEST(BagSource, GivesTheOrderOfRecording) {
  const auto source = OpenFake(BagWithStamps({10, 20, 20, 15}));
  EXPECT_THAT(testing::Stamps(testing::ReadAll(source.get())), ElementsAre(10, 20, 20, 15));
  EXPECT_EQ(source->record_ns(), 103 * kSecond);
}

TEST(BagSource, ABagWithoutAReadableMessageIsAnError) {
  for (const int count : {2, 20}) {
    auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar")});
    for (int i = 0; i < count; ++i) bag->Add(0, i, Payload(10 + i).substr(0, 100));
    const auto source = OpenFake(std::move(bag));
    RadarScan scan;
    EXPECT_EQ(source->Next(&scan), ScanSource::Status::kError);
    EXPECT_THAT(source->error(), HasSubstr("message 1 of /radar: the message is cut off; nor can"));
  }
}

TEST(BagSource, ATopicOfTwoTypesIsThatWithPointClouds) {
  MessageTopic other = Cloud("/radar");
  other.type = "std_msgs/String";
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{other, Cloud("/radar")});
  bag->Add(1, 0, Payload(10));
  InputOptions options;
  options.topic = "/radar";
  std::string error;
  EXPECT_NE(BagSource::Create(std::move(bag), "BAG", options, &error), nullptr) << error;
}

TEST(BagSource, ADamagedMessageIsAnEmptyScan) {
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar")});
  bag->Add(0, 0, Payload(10));
  bag->Add(0, 1, Payload(20).substr(0, 100));
  bag->Add(0, 2, "short");  // not even a stamp
  bag->Add(0, 3, Payload(30));
  const auto source = OpenFake(std::move(bag));
  const auto scans = testing::ReadAll(source.get());
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_EQ(scans[1].stamp_ns, 20);
  EXPECT_TRUE(scans[1].returns.empty());
  EXPECT_EQ(scans[2].returns.size(), 1u);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("message 2 of /radar: the message is cut off"),
                          HasSubstr("message 3 of /radar: cut off or not serialised as ros1")));
}

TEST(BagSource, CloudsWithoutPositionsAreAnError) {
  std::string payload = Payload(10);
  payload[payload.find("x")] = 'q';
  auto bag = std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar")});
  bag->Add(0, 0, payload);
  const auto source = OpenFake(std::move(bag));
  RadarScan scan;
  EXPECT_EQ(source->Next(&scan), ScanSource::Status::kError);
  EXPECT_THAT(source->error(),
              AllOf(HasSubstr("a.bag: message 1 of /radar"), HasSubstr("doppler")));
}

MessageTopic Trigger(const std::string& name) { return {name, "std_msgs/Header", "ros1", {}}; }

std::string TriggerPayload(std::int64_t stamp_ns) {
  std::string payload;
  AppendLittleEndian(std::uint32_t{1}, &payload);
  AppendLittleEndian(static_cast<std::uint32_t>(stamp_ns / kSecond), &payload);
  AppendLittleEndian(static_cast<std::uint32_t>(stamp_ns % kSecond), &payload);
  AppendLittleEndian(std::uint32_t{0}, &payload);
  return payload;
}

// Clouds without stamps, recorded a tenth of a second after the triggers that tell theirs, on
// another clock. The first trigger has no cloud, and the third cloud no trigger.
std::unique_ptr<FakeBag> BagWithTriggers(std::int64_t header_ns) {
  auto bag =
      std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar"), Trigger("/trigger")});
  const std::int64_t tenth = kSecond / 10;
  bag->Add(1, 100 * kSecond, TriggerPayload(7 * kSecond));
  bag->Add(1, 101 * kSecond, TriggerPayload(8 * kSecond + 5));
  bag->Add(0, 101 * kSecond + tenth, Payload(header_ns, 1.0));
  bag->Add(1, 102 * kSecond, TriggerPayload(9 * kSecond));
  bag->Add(0, 102 * kSecond + tenth, Payload(header_ns == 0 ? 0 : header_ns + 1, 2.0));
  bag->Add(0, 103 * kSecond + tenth, Payload(header_ns == 0 ? 0 : header_ns + 2, 3.0));
  return bag;
}

TEST(BagSource, CloudsWithoutStampsHaveThoseOfTheirTriggers) {
  const auto source = OpenFake(BagWithTriggers(0));
  EXPECT_EQ(source->NumScans(), 3);
  EXPECT_THAT(testing::Stamps(testing::ReadAll(source.get())),
              ElementsAre(8 * kSecond + 5, 9 * kSecond, 10 * kSecond));
  EXPECT_EQ(source->Facts().stamp_origin, "triggers /trigger");
  const std::vector<std::string> warnings = source->TakeWarnings();
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], HasSubstr("the stamps of the triggers /trigger are taken instead"));
  EXPECT_THAT(warnings[1], HasSubstr("message 3 of /radar: no trigger on /trigger since"));
}

TEST(BagSource, TriggersAreNotNeededWhereCloudsHaveStamps) {
  EXPECT_THAT(testing::Stamps(testing::ReadAll(OpenFake(BagWithTriggers(50)).get())),
              ElementsAre(50, 51, 52));
  InputOptions options;
  options.trigger_topic = "/trigger";
  EXPECT_EQ(testing::Stamps(testing::ReadAll(OpenFake(BagWithTriggers(50), options).get())).at(0),
            8 * kSecond + 5)
      << "but they are taken where they are asked for";
  options.trigger_topic = "none";
  EXPECT_EQ(testing::Stamps(testing::ReadAll(OpenFake(BagWithTriggers(0), options).get())).at(0),
            101 * kSecond + kSecond / 10);
  options.trigger_topic = "/radar";
  std::string error;
  EXPECT_EQ(BagSource::Create(BagWithTriggers(0), "a.bag", options, &error), nullptr);
  EXPECT_THAT(error,
              HasSubstr("has no triggers (std_msgs/Header) on input.trigger_topic '/radar'"));
}

TEST(BagSource, ScansBeforeTheFirstTriggerArePassedOver) {
  auto bag =
      std::make_unique<FakeBag>(std::vector<MessageTopic>{Cloud("/radar"), Trigger("/trigger")});
  bag->Add(0, 1, Payload(0));
  bag->Add(1, 2, TriggerPayload(7 * kSecond));
  bag->Add(0, 3, Payload(0));
  const auto source = OpenFake(std::move(bag));
  EXPECT_THAT(testing::Stamps(testing::ReadAll(source.get())), ElementsAre(7 * kSecond));
  EXPECT_THAT(source->TakeWarnings().back(), HasSubstr("recorded before the first trigger"));
}

}  // namespace
}  // namespace radive
