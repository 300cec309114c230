// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "radive/io/bags/bag_source.h"
#include "radive/io/bags/message_source.h"

namespace radive {

// Small, so that a file which claims much is found out.
inline MessageLimits FuzzLimits() {
  MessageLimits limits;
  limits.message = 1 << 20;
  return limits;
}

// Reads all messages of a bag.
inline void ReadMessages(MessageSource* bag) {
  std::vector<int> all(bag->topics().size());
  std::iota(all.begin(), all.end(), 0);
  bag->Select(all);
  Message message;
  std::size_t sum = 0;
  while (bag->Next(&message) == MessageSource::Status::kMessage) {
    // Touches what was given, so that a view of memory that is gone shows.
    for (const char byte : message.payload) sum += static_cast<unsigned char>(byte);
  }
  volatile std::size_t kept = sum;
  static_cast<void>(kept);
}

// Reads the point clouds of a bag, where there is one topic with them.
inline void ReadScans(std::unique_ptr<MessageSource> bag) {
  std::string error;
  const auto source = BagSource::Create(std::move(bag), "bag", InputOptions(), &error);
  if (source == nullptr) return;
  RadarScan scan;
  while (source->Next(&scan) == ScanSource::Status::kScan) {
  }
}

// Both, of the bag that `open` opens; nothing when it refuses it.
template <typename Open>
void ReadBag(const Open& open) {
  std::string error;
  if (std::unique_ptr<MessageSource> bag = open(&error)) ReadMessages(bag.get());
  // SQLite may judge a damaged file differently the second time.
  if (std::unique_ptr<MessageSource> bag = open(&error)) ReadScans(std::move(bag));
}

}  // namespace radive
