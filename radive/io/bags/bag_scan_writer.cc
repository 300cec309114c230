// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/bag_scan_writer.h"

#include <glog/logging.h>

#include <utility>

#include "radive/io/bags/mcap_writer.h"
#include "radive/io/bags/message_writer.h"
#include "radive/io/bags/open_message_source.h"
#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/bags/sqlite_bag_writer.h"

namespace radive {
namespace {

struct BagForm {
  const char* name;
  BagFormat format;
  Compression compression;
  bool index;
};

constexpr BagForm kForms[] = {
    {"rosbag1", BagFormat::kRosbag1, Compression::kNone, true},
    {"rosbag1_bz2", BagFormat::kRosbag1, Compression::kBz2, true},
    {"rosbag1_lz4", BagFormat::kRosbag1, Compression::kLz4, true},
    {"rosbag1_unindexed", BagFormat::kRosbag1, Compression::kNone, false},
    {"rosbag2", BagFormat::kRosbag2, Compression::kNone, true},
    {"rosbag2_zstd", BagFormat::kRosbag2, Compression::kZstd, true},
    {"mcap", BagFormat::kMcap, Compression::kNone, true},
    {"mcap_lz4", BagFormat::kMcap, Compression::kLz4, true},
    {"mcap_zstd", BagFormat::kMcap, Compression::kZstd, true},
    {"mcap_unindexed", BagFormat::kMcap, Compression::kNone, false},
};

std::unique_ptr<MessageWriter> Create(const BagForm& form,
                                      const std::filesystem::path& folder,
                                      std::string* error) {
  switch (form.format) {
    case BagFormat::kRosbag1: {
      Ros1BagWriter::Options options;
      options.compression = form.compression;
      options.index = form.index;
      return Ros1BagWriter::Create(folder / "drive.bag", options, error);
    }
    case BagFormat::kRosbag2: {
      SqliteBagWriter::Options options;
      options.zstd_messages = form.compression == Compression::kZstd;
      // Not that of the folder, which has another one until it is complete.
      options.name = "drive";
      return SqliteBagWriter::Create(folder, options, error);
    }
    case BagFormat::kMcap: {
      McapWriter::Options options;
      options.compression = form.compression;
      options.index = form.index;
      return McapWriter::Create(folder / "drive.mcap", options, error);
    }
  }
  return nullptr;
}

class BagScanWriter : public ScanWriter {
 public:
  BagScanWriter(std::unique_ptr<MessageWriter> bag, bool is_ros1)
      : bag_(std::move(bag)),
        encoding_(is_ros1 ? "ros1" : "cdr"),
        topic_(bag_->AddTopic({"/radar",
                               is_ros1 ? "sensor_msgs/PointCloud2" : "sensor_msgs/msg/PointCloud2",
                               encoding_,
                               {}})) {}

  bool Add(const RadarScan& scan, std::string* error) override {
    const std::string payload = EncodePointCloud2(scan, encoding_, "radar");
    return bag_->Write(topic_, scan.stamp_ns, payload, error);
  }

  bool Finish(std::string* error) override { return bag_->Close(error); }

 private:
  const std::unique_ptr<MessageWriter> bag_;
  const std::string encoding_;
  const int topic_;
};

}  // namespace

const std::vector<std::string>& BagScanWriterNames() {
  static const std::vector<std::string>* const names = [] {
    auto* const list = new std::vector<std::string>();
    for (const BagForm& form : kForms) list->emplace_back(form.name);
    return list;
  }();
  return *names;
}

std::unique_ptr<ScanWriter> OpenBagScanWriter(const std::string& format,
                                              const std::filesystem::path& folder,
                                              std::string* error) {
  for (const BagForm& form : kForms) {
    if (format != form.name) continue;
    std::unique_ptr<MessageWriter> bag = Create(form, folder, error);
    if (bag == nullptr) return nullptr;
    return std::make_unique<BagScanWriter>(std::move(bag), form.format == BagFormat::kRosbag1);
  }
  LOG(FATAL) << "unknown bag format " << format;
  return nullptr;
}

}  // namespace radive
