// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/raw_evidence.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "radive/io/datasets/dataset.h"
#include "radive/io/points/raw_layout.h"

namespace radive {
namespace {

constexpr double kMinShare = 0.9;           // of the records that must agree
constexpr std::size_t kMostRecords = 2000;  // looked at
constexpr std::size_t kMinRecords = 3;

double Value(const RawLayout& layout, const char* record, std::string_view name) {
  for (const PointField& field : layout.fields) {
    if (field.name == name) return ReadNumber(record + field.offset, field.type, false);
  }
  return std::nan("");
}

bool Agrees(const RecordProof& proof, const RawLayout& layout, const char* record) {
  const double value = Value(layout, record, proof.field);
  const Eigen::Vector3d position(
      Value(layout, record, "x"), Value(layout, record, "y"), Value(layout, record, "z"));
  const double range = position.norm();
  if (!(range > 0.0 && range < 1e4)) return false;
  if (proof.kind == RecordProof::Kind::kScanIndex) {
    return value <= 0.0 && value >= -20.0 && value == std::round(value);
  }
  return std::abs(value - range) <= 0.01 * range;
}

// What was seen; nothing when the numbers do not prove it.
std::optional<std::string> EvidenceFor(const RecordProof& proof, std::string_view bytes) {
  const RawLayout layout = KnownLayout(proof.layout);
  const std::size_t count = std::min(bytes.size() / layout.record_size, kMostRecords);
  if (bytes.size() % layout.record_size != 0 || count < kMinRecords) return std::nullopt;
  std::size_t num_agreeing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    num_agreeing += Agrees(proof, layout, bytes.data() + i * layout.record_size) ? 1 : 0;
  }
  if (static_cast<double>(num_agreeing) < kMinShare * static_cast<double>(count)) {
    return std::nullopt;
  }
  return proof.field +
         (proof.kind == RecordProof::Kind::kRange ? " is |x y z|" : " is a scan index") + " in " +
         std::to_string(num_agreeing) + " of " + std::to_string(count) + " records";
}

}  // namespace

std::string ProvenLayout(std::string_view bytes, std::string* evidence) {
  for (const Dataset& dataset : Datasets()) {
    for (const DatasetSensor& sensor : dataset.sensors) {
      if (sensor.proof.layout.empty()) continue;
      const std::optional<std::string> found = EvidenceFor(sensor.proof, bytes);
      if (!found) continue;
      *evidence = *found;
      return sensor.proof.layout;
    }
  }
  return "";
}

}  // namespace radive
