// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bags/message_source.h"
#include "radive/io/points/point_table.h"

namespace radive {

// The two messages of sensor_msgs that hold points.
enum class PointCloudType {
  kNone,
  kPointCloud2,  // records of named fields
  kPointCloud    // x y z, and named channels of one float a point
};

// Type of the messages of a topic: "sensor_msgs/PointCloud2" and "sensor_msgs/msg/PointCloud2" are
// the same.
PointCloudType PointCloudTypeOf(const MessageTopic& topic);

// True when the reader below knows the serialisation of the topic.
bool IsRosEncoding(const MessageTopic& topic);

// Reads the header's stamp of a message of a point-cloud topic [ns]; with `frame_id` also what it
// is measured in, a view of `payload`. False when it is cut off or has another encoding.
bool ReadPointCloudStamp(std::string_view payload,
                         const MessageTopic& topic,
                         std::int64_t* stamp_ns,
                         std::string_view* frame_id = nullptr);

// Reads the points of a message of a point-cloud topic. `table` may be a view of `payload`. False,
// with the reason in `error`, when the message is cut off or contradicts itself.
//
// The flag is_dense is not believed: points may be no numbers all the same. A field's count of 0 is
// taken as 1, and row_step is not looked at where there is one row. What drivers set wrongly
// although the size of the data tells it (row_step, point_step, width, count) is taken from that,
// with a line in `remarks`.
bool ReadPointCloud(std::string_view payload,
                    const MessageTopic& topic,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error);

}  // namespace radive
