// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_source.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "radive/io/bags/point_cloud_messages.h"
#include "radive/io/bags/topic_names.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// Header stamps that are the same in so many messages are no stamps.
constexpr std::size_t kMessagesLookedAt = 8;

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
  // One name may stand for several types.
  for (std::size_t k = 0; found.size() > 1 && !wanted.empty() && k < found.size();) {
    if (IsPointCloud(candidates[k])) {
      ++k;
      continue;
    }
    found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(k));
  }
  if (found.empty() && wanted.empty()) {
    *error = "has no point clouds, " + expected + "; it has: " + NamesOf(topics);
  } else if (found.empty()) {
    *error = "has no topic " + Quoted(wanted) + "; it has: " + NamesOf(topics);
  } else if (found.size() > 1) {
    *error =
        (wanted.empty() ? "has several topics with point clouds, say with input.topic which one: "
                        : "has several topics " + Quoted(wanted) + " with point clouds: ") +
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

// When none of the first messages can be read.
ScanSource::Status BagSource::FailUnreadable() {
  error_ = first_reason_;
  if (num_unreadable_ > 1) {
    error_ +=
        "; nor can the " + std::to_string(num_unreadable_ - 1) + " messages behind it be read";
  }
  return Status::kError;
}

// Sets the returns of a scan. A message that cannot be read is an empty scan, because every scan
// of the drive gets its line in the trajectory; but when the very first one has no positions, none
// will.
ScanSource::Status BagSource::ReadReturns(const Message& message, RadarScan* scan) {
  PointTable table;
  std::vector<std::string> remarks;
  std::string reason;
  const bool is_read = ReadPointCloud(message.payload, topic(), &table, &remarks, &reason);
  for (const std::string& remark : remarks) {
    counted_.Add("point clouds that contradict themselves in " + place_,
                 scan->place + ": " + remark);
  }
  if (!is_read) {
    if (num_unreadable_++ == 0) first_reason_ = scan->place + ": " + reason;
    if (!has_read_ && num_unreadable_ == kMessagesLookedAt) return FailUnreadable();
    counted_.Add("damaged point clouds in " + place_,
                 scan->place + ": " + reason + "; taken as an empty scan");
    return Status::kScan;
  }
  has_read_ = true;
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
    if (status == MessageSource::Status::kEnd) {
      return has_read_ || num_unreadable_ == 0 ? Status::kEnd : FailUnreadable();
    }
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
    std::string_view frame_id;
    if (ReadPointCloudStamp(message.payload, topic(), &stamped->header_ns, &frame_id)) {
      const std::string remark = frame_watch_.Look(frame_id);
      if (!remark.empty()) {
        counted_.Add("point clouds of another frame in " + place_,
                     stamped->scan.place + ": " + remark);
      }
      break;
    }
    counted_.Add("damaged messages in " + place_,
                 stamped->scan.place + ": cut off or not serialised as " + topic().encoding +
                     "; it is passed over");
  }
  return needs_returns ? ReadReturns(message, &stamped->scan) : Status::kScan;
}

const std::string& BagSource::TriggerName() const {
  return bag_->topics()[static_cast<std::size_t>(trigger_topic_)].name;
}

// Looks at the first messages: reads until two header stamps differ and a message can be read.
void BagSource::ChooseStamps() {
  if (is_trigger_set_) {
    stamp_origin_ = StampOrigin::kTrigger;
    return;
  }
  stamp_origin_ = StampOrigin::kRecord;
  while (held_back_.size() < kMessagesLookedAt &&
         (stamp_origin_ == StampOrigin::kRecord || num_unreadable_ == held_back_.size())) {
    Stamped stamped;
    status_after_held_back_ = ReadMessage(/*needs_returns=*/true, &stamped);
    if (status_after_held_back_ != Status::kScan) break;
    held_back_.push_back(std::move(stamped));
    if (held_back_.back().header_ns != held_back_.front().header_ns) {
      stamp_origin_ = StampOrigin::kHeader;
    }
  }
  if (status_after_held_back_ == Status::kError && !has_read_) held_back_.clear();
  if (held_back_.empty()) return;
  if (stamp_origin_ == StampOrigin::kHeader && !HeadersRunAsRecorded()) {
    stamp_origin_ = StampOrigin::kRecord;
    return;
  }
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

// False, with a warning, when the header stamps say a rate that no radar has, and the times of
// recording one that it has. Reads some messages more where the first two look like that.
bool BagSource::HeadersRunAsRecorded() {
  const auto is_plausible = [](double interval) { return interval >= 0.004 && interval <= 2.5; };
  const auto seconds = [](std::int64_t end_ns, std::int64_t begin_ns) {
    return 1e-9 * (static_cast<double>(end_ns) - static_cast<double>(begin_ns));
  };
  const auto interval = [&](std::int64_t Stamped::*time_ns) {
    std::vector<double> intervals;
    for (std::size_t i = 1; i < held_back_.size(); ++i) {
      intervals.push_back(seconds(held_back_[i].*time_ns, held_back_[i - 1].*time_ns));
    }
    std::sort(intervals.begin(), intervals.end());
    return intervals.empty() ? 0.1 : intervals[intervals.size() / 2];
  };
  if (is_plausible(interval(&Stamped::header_ns))) return true;
  while (held_back_.size() < kMessagesLookedAt && status_after_held_back_ == Status::kScan) {
    Stamped stamped;
    status_after_held_back_ = ReadMessage(/*needs_returns=*/true, &stamped);
    if (status_after_held_back_ == Status::kScan) held_back_.push_back(std::move(stamped));
  }
  const double by_header = interval(&Stamped::header_ns);
  const double by_record = interval(&Stamped::record_ns);
  const bool is_regular = held_back_.size() == kMessagesLookedAt && by_header > 0.0;
  if (!is_regular || is_plausible(by_header) || !is_plausible(by_record)) return true;
  warnings_.push_back(
      place_ + ": the header stamps of " + topic().name +
      FormatText(" are %.4g s apart, but were recorded %.4g s apart", by_header, by_record) +
      "; the times of recording are taken instead");
  return false;
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
    record_ns_ = stamped.record_ns;
    return Status::kScan;
  }
}

ScanSource::Status BagSource::Next(RadarScan* scan) {
  return Advance(/*needs_returns=*/true, scan);
}

ScanSource::Status BagSource::PassOver(RadarScan* scan) {
  return Advance(/*needs_returns=*/false, scan);
}

}  // namespace radive
