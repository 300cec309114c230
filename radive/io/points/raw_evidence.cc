// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/raw_evidence.h"

#include <glog/logging.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "radive/io/points/raw_layout.h"

namespace radive {
namespace {

constexpr double kMinShare = 0.9;           // of the records that must agree
constexpr std::size_t kMostRecords = 2000;  // looked at
constexpr std::size_t kMinRecords = 3;

enum class Proof { kRange, kScanIndex };

struct Candidate {
  const char* layout;
  Proof proof;
  const char* field;
};

constexpr Candidate kCandidates[] = {
    {"hercules29", Proof::kRange, "r"},
    {"tj4d8", Proof::kRange, "range"},
    {"mscrad17", Proof::kRange, "range"},
    {"vod7", Proof::kScanIndex, "time"},
};

RawLayout LayoutOf(const std::string& name) {
  std::string error;
  std::optional<RawLayout> layout = ParseRawLayout(name, &error);
  CHECK(layout) << error;
  return *std::move(layout);
}

double Value(const RawLayout& layout, const char* record, std::string_view name) {
  for (const PointField& field : layout.fields) {
    if (field.name == name) return ReadNumber(record + field.offset, field.type, false);
  }
  return std::nan("");
}

bool Agrees(const Candidate& candidate, const RawLayout& layout, const char* record) {
  const double value = Value(layout, record, candidate.field);
  const Eigen::Vector3d position(
      Value(layout, record, "x"), Value(layout, record, "y"), Value(layout, record, "z"));
  const double range = position.norm();
  if (!(range > 0.0 && range < 1e4)) return false;
  if (candidate.proof == Proof::kScanIndex) {
    return value <= 0.0 && value >= -20.0 && value == std::round(value);
  }
  return std::abs(value - range) <= 0.01 * range;
}

}  // namespace

std::string ProvenLayout(std::string_view bytes, std::string* evidence) {
  for (const Candidate& candidate : kCandidates) {
    const RawLayout layout = LayoutOf(candidate.layout);
    const std::size_t count = std::min(bytes.size() / layout.record_size, kMostRecords);
    if (bytes.size() % layout.record_size != 0 || count < kMinRecords) continue;
    std::size_t num_agreeing = 0;
    for (std::size_t i = 0; i < count; ++i) {
      num_agreeing += Agrees(candidate, layout, bytes.data() + i * layout.record_size) ? 1 : 0;
    }
    if (static_cast<double>(num_agreeing) < kMinShare * static_cast<double>(count)) continue;
    *evidence = std::string(candidate.field) +
                (candidate.proof == Proof::kRange ? " is |x y z|" : " is a scan index") + " in " +
                std::to_string(num_agreeing) + " of " + std::to_string(count) + " records";
    return candidate.layout;
  }
  return "";
}

std::vector<std::string> LayoutsOfSize(std::size_t size) {
  std::vector<std::string> names;
  for (const std::string& name : RawLayoutNames()) {
    if (size > 0 && size % LayoutOf(name).record_size == 0) names.push_back(name);
  }
  return names;
}

}  // namespace radive
