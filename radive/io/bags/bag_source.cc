// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_source.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "radive/io/bags/point_cloud_messages.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

// Header stamps that are the same in so many messages are no stamps.
constexpr std::size_t kMessagesLookedAt = 8;

// "/tf (tf2_msgs/TFMessage, 517 messages)".
std::string NameOf(const MessageTopic& topic) {
  std::string text = topic.name + " (" + topic.type;
  if (topic.num_messages) text += ", " + std::to_string(*topic.num_messages) + " messages";
  return text + ")";
}

std::string NamesOf(const std::vector<MessageTopic>& topics) {
  constexpr std::size_t kMostNames = 50;
  std::string names;
  for (std::size_t i = 0; i < std::min(topics.size(), kMostNames); ++i) {
    names += (i == 0 ? "" : ", ") + NameOf(topics[i]);
  }
  if (topics.size() > kMostNames) names += ", ...";
  return topics.empty() ? "no topics" : names;
}

bool IsPointCloud(const MessageTopic& topic) {
  return PointCloudTypeOf(topic) != PointCloudType::kNone;
}

// The topic that `wanted` names, or the only one with point clouds. Nothing, with the topics in
// `error`, when there is none, or several.
std::optional<int> ChooseScanTopic(const std::vector<MessageTopic>& topics,
                                   const std::string& wanted,
                                   std::string* error) {
  const std::string expected = "expected sensor_msgs PointCloud2 or PointCloud";
  std::vector<int> found;
  std::vector<MessageTopic> candidates;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const bool is_candidate = wanted.empty()
                                  ? IsPointCloud(topics[i]) && topics[i].num_messages != 0u
                                  : topics[i].name == wanted;
    if (!is_candidate) continue;
    found.push_back(static_cast<int>(i));
    candidates.push_back(topics[i]);
  }
  if (found.empty() && wanted.empty()) {
    *error = "has no point clouds, " + expected + "; it has: " + NamesOf(topics);
  } else if (found.empty()) {
    *error = "has no topic " + Quoted(wanted) + "; it has: " + NamesOf(topics);
  } else if (found.size() > 1) {
    *error = "has several topics with point clouds, say with input.topic which one: " +
             NamesOf(candidates);
  } else if (!IsPointCloud(candidates.front())) {
    *error = "cannot read messages of " + NameOf(candidates.front()) + ", " + expected;
  } else if (!IsRosEncoding(candidates.front())) {
    *error = "cannot read " + NameOf(candidates.front()) + ": it is serialised as " +
             Quoted(candidates.front().encoding) + ", expected ros1 or cdr";
  } else {
    return found.front();
  }
  return std::nullopt;
}

// a + b - c. Without signs in between: hostile stamps lie further apart than there are numbers.
std::int64_t Shifted(std::int64_t a, std::int64_t b, std::int64_t c) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b) -
                                   static_cast<std::uint64_t>(c));
}

bool IsTrigger(const MessageTopic& topic) {
  return (topic.type == "std_msgs/Header" || topic.type == "std_msgs/msg/Header") &&
         IsRosEncoding(topic);
}

// The topic with triggers that `wanted` names, or the only one; -1 when there is none, or several.
// Nothing, with the reason in `error`, when the named one is not there.
std::optional<int> ChooseTrigger(const std::vector<MessageTopic>& topics,
                                 const std::string& wanted,
                                 std::string* error) {
  std::vector<int> found;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (IsTrigger(topics[i]) && (wanted.empty() || topics[i].name == wanted)) {
      found.push_back(static_cast<int>(i));
    }
  }
  if (wanted.empty() || wanted == "none")
    return wanted.empty() && found.size() == 1 ? found[0] : -1;
  if (!found.empty()) return found.front();
  *error = "has no triggers (std_msgs/Header) on input.trigger_topic " + Quoted(wanted) +
           "; it has: " + NamesOf(topics);
  return std::nullopt;
}

}  // namespace

std::unique_ptr<BagSource> BagSource::Open(const std::filesystem::path& path,
                                           BagFormat format,
                                           const InputOptions& options,
                                           std::string* error) {
  MessageLimits limits;
  limits.message = static_cast<std::uint64_t>(options.max_message_bytes);
  std::unique_ptr<MessageSource> bag = OpenMessageSource(path, format, limits, error);
  if (bag == nullptr) return nullptr;
  return Create(std::move(bag), path.string(), options, error);
}

std::unique_ptr<BagSource> BagSource::Create(std::unique_ptr<MessageSource> bag,
                                             const std::string& place,
                                             const InputOptions& options,
                                             std::string* error) {
  std::string reason;
  const std::optional<int> topic = ChooseScanTopic(bag->topics(), options.topic, &reason);
  if (!topic) {
    *error = place + ": " + reason;
    for (const std::string& warning : bag->TakeWarnings()) *error += "; " + warning;
    return nullptr;
  }
  const std::optional<int> trigger = ChooseTrigger(bag->topics(), options.trigger_topic, &reason);
  if (!trigger) {
    *error = place + ": " + reason;
    return nullptr;
  }
  std::vector<int> selected = {*topic};
  if (*trigger >= 0) selected.push_back(*trigger);
  bag->Select(selected);
  return std::unique_ptr<BagSource>(
      new BagSource(std::move(bag), *topic, *trigger, place, options));
}

BagSource::BagSource(std::unique_ptr<MessageSource> bag,
                     int topic,
                     int trigger_topic,
                     std::string place,
                     const InputOptions& options)
    : bag_(std::move(bag)),
      topic_(topic),
      trigger_topic_(trigger_topic),
      is_trigger_set_(trigger_topic >= 0 && !options.trigger_topic.empty()),
      place_(std::move(place)),
      converter_(options) {}

std::string BagSource::Description() const {
  return bag_->Description() + ", topic " + NameOf(topic());
}

std::optional<int> BagSource::NumScans() const {
  const std::optional<std::uint64_t> number = topic().num_messages;
  if (!number || *number > std::uint64_t{std::numeric_limits<int>::max()}) return std::nullopt;
  return static_cast<int>(*number);
}

SourceFacts BagSource::Facts() const {
  SourceFacts facts;
  facts.format = bag_->Description();
  facts.place = place_ + ", topic " + NameOf(topic());
  if (stamp_origin_ == StampOrigin::kHeader) facts.stamp_origin = "header stamps";
  if (stamp_origin_ == StampOrigin::kRecord) facts.stamp_origin = "times of recording";
  if (stamp_origin_ == StampOrigin::kTrigger) facts.stamp_origin = "triggers " + TriggerName();
  facts.fields = converter_.Summaries();
  return facts;
}

// Sets the returns of a scan. A message that cannot be read is an empty scan, because every scan
// of the drive gets its line in the trajectory; but when the very first one has no positions, none
// will.
ScanSource::Status BagSource::ReadReturns(const Message& message, RadarScan* scan) {
  PointTable table;
  std::string reason;
  if (!ReadPointCloud(message.payload, topic(), &table, &reason)) {
    counted_.Add("damaged point clouds in " + place_,
                 scan->place + ": " + reason + "; taken as an empty scan");
    return Status::kScan;
  }
  if (table.num_points == 0 && table.fields.empty()) return Status::kScan;
  if (converter_.Convert(table, scan, &reason)) {
    has_returns_ = true;
    return Status::kScan;
  }
  if (!has_returns_) {
    error_ = scan->place + ": " + reason;
    return Status::kError;
  }
  counted_.Add("point clouds without positions in " + place_,
               scan->place + ": " + reason + "; taken as an empty scan");
  return Status::kScan;
}

ScanSource::Status BagSource::ReadMessage(bool needs_returns, Stamped* stamped) {
  Message message;
  for (;;) {
    const MessageSource::Status status = bag_->Next(&message);
    for (std::string& warning : bag_->TakeWarnings()) warnings_.push_back(std::move(warning));
    if (status == MessageSource::Status::kError) {
      error_ = bag_->error();
      return Status::kError;
    }
    if (status == MessageSource::Status::kEnd) return Status::kEnd;
    if (message.topic == trigger_topic_) {
      std::int64_t stamp_ns = 0;
      const MessageTopic& trigger = bag_->topics()[static_cast<std::size_t>(trigger_topic_)];
      if (ReadPointCloudStamp(message.payload, trigger, &stamp_ns)) trigger_ns_ = stamp_ns;
      continue;
    }
    ++num_messages_;
    stamped->scan = RadarScan();
    stamped->scan.place =
        place_ + ": message " + std::to_string(num_messages_) + " of " + topic().name;
    stamped->record_ns = message.record_ns;
    stamped->trigger_ns = std::exchange(trigger_ns_, std::nullopt);
    if (ReadPointCloudStamp(message.payload, topic(), &stamped->header_ns)) break;
    counted_.Add("damaged messages in " + place_,
                 stamped->scan.place + ": cut off or not serialised as " + topic().encoding +
                     "; it is passed over");
  }
  return needs_returns ? ReadReturns(message, &stamped->scan) : Status::kScan;
}

const std::string& BagSource::TriggerName() const {
  return bag_->topics()[static_cast<std::size_t>(trigger_topic_)].name;
}

// Looks at the first messages: reads until two header stamps differ.
void BagSource::ChooseStamps() {
  if (is_trigger_set_) {
    stamp_origin_ = StampOrigin::kTrigger;
    return;
  }
  stamp_origin_ = StampOrigin::kRecord;
  while (held_back_.size() < kMessagesLookedAt && stamp_origin_ == StampOrigin::kRecord) {
    Stamped stamped;
    status_after_held_back_ = ReadMessage(/*needs_returns=*/true, &stamped);
    if (status_after_held_back_ != Status::kScan) break;
    held_back_.push_back(std::move(stamped));
    if (held_back_.back().header_ns != held_back_.front().header_ns) {
      stamp_origin_ = StampOrigin::kHeader;
    }
  }
  if (held_back_.empty()) return;
  const std::int64_t stamp_ns = held_back_.front().header_ns;
  if (held_back_.size() == 1 && stamp_ns != 0) stamp_origin_ = StampOrigin::kHeader;
  if (stamp_origin_ != StampOrigin::kRecord) return;
  const bool has_triggers =
      std::any_of(held_back_.begin(), held_back_.end(), [](const Stamped& stamped) {
        return stamped.trigger_ns.has_value();
      });
  if (has_triggers) stamp_origin_ = StampOrigin::kTrigger;
  warnings_.push_back(place_ + ": the header stamps of " + topic().name + " are all " +
                      FormatStamp(stamp_ns) + "; the " +
                      (has_triggers ? "stamps of the triggers " + TriggerName()
                                    : std::string("times of recording")) +
                      " are taken instead");
}

bool BagSource::SetStamp(const Stamped& stamped, RadarScan* scan) {
  switch (stamp_origin_) {
    case StampOrigin::kTrigger:
      if (stamped.trigger_ns) {
        record_to_trigger_ns_ = Shifted(*stamped.trigger_ns, 0, stamped.record_ns);
        has_had_trigger_ = true;
      }
      scan->stamp_ns = Shifted(stamped.record_ns, record_to_trigger_ns_, 0);
      if (stamped.trigger_ns || !has_had_trigger_) break;
      counted_.Add("scans without a trigger of their own in " + place_,
                   scan->place + ": no trigger on " + TriggerName() +
                       " since the scan before; stamped by the time of recording");
      break;
    case StampOrigin::kRecord:
      scan->stamp_ns = stamped.record_ns;
      break;
    case StampOrigin::kHeader:
    case StampOrigin::kUnknown:
      scan->stamp_ns = stamped.header_ns;
      break;
  }
  return stamp_origin_ != StampOrigin::kTrigger || has_had_trigger_;
}

ScanSource::Status BagSource::Advance(bool needs_returns, RadarScan* scan) {
  if (stamp_origin_ == StampOrigin::kUnknown) ChooseStamps();
  for (;;) {
    Stamped stamped;
    if (!held_back_.empty()) {
      stamped = std::move(held_back_.front());
      held_back_.pop_front();
    } else {
      if (status_after_held_back_ == Status::kScan) {
        status_after_held_back_ = ReadMessage(needs_returns, &stamped);
      }
      if (status_after_held_back_ != Status::kScan) {
        counted_.Finish();
        for (std::string& warning : counted_.Take()) warnings_.push_back(std::move(warning));
        return status_after_held_back_;
      }
    }
    for (std::string& warning : counted_.Take()) warnings_.push_back(std::move(warning));
    *scan = std::move(stamped.scan);
    if (!SetStamp(stamped, scan)) {
      counted_.Add("scans before the first trigger in " + place_,
                   scan->place + ": recorded before the first trigger on " + TriggerName() +
                       "; it is passed over");
      continue;
    }
    if (!last_ns_ || scan->stamp_ns > *last_ns_) {
      last_ns_ = scan->stamp_ns;
      return Status::kScan;
    }
    const bool is_same = scan->stamp_ns == *last_ns_;
    counted_.Add(
        "scans with a stamp " +
            std::string(is_same ? "that was there before" : "before the last one's") + " in " +
            place_,
        scan->place + ": the stamp " + FormatStamp(scan->stamp_ns) +
            (is_same ? " is that of the scan before" : " is earlier than that of the scan before") +
            "; it is passed over");
  }
}

ScanSource::Status BagSource::Next(RadarScan* scan) {
  return Advance(/*needs_returns=*/true, scan);
}

ScanSource::Status BagSource::Skip(int count) {
  RadarScan dropped;
  for (int i = 0; i < count; ++i) {
    const Status status = Advance(/*needs_returns=*/false, &dropped);
    if (status != Status::kScan) return status;
  }
  return Status::kScan;
}

}  // namespace radive
