// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "radive/io/bags/frame_watch.h"
#include "radive/io/bags/message_source.h"
#include "radive/io/bags/open_message_source.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_source.h"
#include "radive/util/counted_warnings.h"

namespace radive {

// The point clouds (sensor_msgs PointCloud2 or PointCloud) on one topic of a bag as scans.
//
// The stamp of a scan is its header's. Where these are 0 or do not change, or input.trigger_topic
// says so, it is that of the last trigger that was recorded before the scan; a scan without one of
// its own is as much later than the scan before as it was recorded later. Without triggers it is
// the time of recording. Either comes with a warning. Scans come in the order of recording, see
// OrderedSource.
class BagSource : public ScanSource {
 public:
  // `options` must be valid; input.topic names the topic, and may be empty when the bag has one
  // with point clouds only. Null, with the place and the expectation in `error`, and the topics of
  // the bag where these are the reason, when there is nothing to read.
  static std::unique_ptr<BagSource> Open(const std::filesystem::path& path,
                                         BagFormat format,
                                         const InputOptions& options,
                                         std::string* error);

  // The same for a bag that is open; `place` names it in messages.
  static std::unique_ptr<BagSource> Create(std::unique_ptr<MessageSource> bag,
                                           const std::string& place,
                                           const InputOptions& options,
                                           std::string* error);

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::optional<std::int64_t> record_ns() const override { return record_ns_; }
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;

 private:
  enum class StampOrigin { kUnknown, kHeader, kRecord, kTrigger };

  // A scan whose stamp is not chosen yet.
  struct Stamped {
    RadarScan scan;
    std::int64_t header_ns = 0;
    std::int64_t record_ns = 0;
    std::optional<std::int64_t> trigger_ns;
  };

  BagSource(std::unique_ptr<MessageSource> bag,
            int topic,
            int trigger_topic,
            std::string place,
            const InputOptions& options);

  Status Advance(bool needs_returns, RadarScan* scan);
  Status ReadMessage(bool needs_returns, Stamped* stamped);
  Status ReadReturns(const Message& message, RadarScan* scan);
  Status FailUnreadable();
  void ChooseStamps();
  bool HeadersRunAsRecorded();
  // False for a scan that comes before the first trigger.
  bool SetStamp(const Stamped& stamped, RadarScan* scan);
  const std::string& TriggerName() const;
  const MessageTopic& topic() const { return bag_->topics()[static_cast<std::size_t>(topic_)]; }

  const std::unique_ptr<MessageSource> bag_;
  const int topic_;
  const int trigger_topic_;  // -1: none
  const bool is_trigger_set_;
  const std::string place_;
  PointConverter converter_;
  CountedWarnings counted_;
  FrameWatch frame_watch_;
  int num_messages_ = 0;      // read so far
  bool has_returns_ = false;  // of some message
  bool has_read_ = false;     // some message, be it without returns
  std::size_t num_unreadable_ = 0;
  std::string first_reason_;  // of a message that cannot be read
  StampOrigin stamp_origin_ = StampOrigin::kUnknown;
  std::deque<Stamped> held_back_;
  Status status_after_held_back_ = Status::kScan;
  std::int64_t record_ns_ = 0;              // of the scan given last
  std::optional<std::int64_t> trigger_ns_;  // read, and not taken by a scan yet
  std::int64_t record_to_trigger_ns_ = 0;   // of the last scan that had a trigger
  bool has_had_trigger_ = false;
};

}  // namespace radive
