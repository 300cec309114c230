// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/merged_source.h"

#include <glog/logging.h>

#include <cmath>
#include <utility>

#include "radive/util/number_text.h"

namespace radive {
namespace {

// Radars of one drive are switched on within this time [s].
constexpr double kFarApart = 60.0;

}  // namespace

MergedSource::MergedSource(std::vector<Radar> radars) {
  CHECK(!radars.empty());
  for (Radar& radar : radars) {
    Input& input = inputs_.emplace_back();
    input.source = std::move(radar.source);
    input.number = radar.number;
  }
}

bool MergedSource::Read(Input* input) {
  if (input->is_read) return true;
  input->status = PassOn(input->source->Next(&input->next), input->source.get());
  input->next.radar = input->number;
  input->is_read = true;
  return input->status != Status::kError;
}

// Stamps of different clocks would play one radar behind the other.
void MergedSource::CompareClocks() {
  has_compared_ = true;
  const Input& first = inputs_.front();
  for (const Input& input : inputs_) {
    if (first.status != Status::kScan || input.status != Status::kScan) continue;
    const double apart = 1e-9 * (static_cast<double>(input.next.stamp_ns) -
                                 static_cast<double>(first.next.stamp_ns));
    if (std::abs(apart) <= kFarApart) continue;
    warnings_.push_back(
        FormatText("radar %d begins %.6g s %s radar %d by its stamps: have they the same clock?",
                   input.number,
                   std::abs(apart),
                   apart > 0.0 ? "after" : "before",
                   first.number));
  }
}

ScanSource::Status MergedSource::Next(RadarScan* scan) {
  Input* earliest = nullptr;
  for (Input& input : inputs_) {
    if (!Read(&input)) return Status::kError;
    if (input.status == Status::kEnd) continue;
    if (earliest == nullptr || input.next.stamp_ns < earliest->next.stamp_ns) earliest = &input;
  }
  if (!has_compared_) CompareClocks();
  if (earliest == nullptr) return Status::kEnd;
  std::swap(*scan, earliest->next);
  earliest->is_read = false;
  return Status::kScan;
}

std::string MergedSource::Description() const {
  std::string description = std::to_string(inputs_.size()) + " radars in the order of their stamps";
  for (const Input& input : inputs_) description += "; " + input.source->Description();
  return description;
}

SourceFacts MergedSource::Facts() const { return inputs_.front().source->Facts(); }

std::optional<int> MergedSource::NumScans() const {
  int sum = 0;
  for (const Input& input : inputs_) {
    const std::optional<int> count = input.source->NumScans();
    if (!count) return std::nullopt;
    sum += *count;
  }
  return sum;
}

}  // namespace radive
