// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/axes.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr double kMinForwardShare = 0.98;  // of the returns that have z > 0 in right-down-forward
constexpr double kMaxForwardX = 0.9;       // share with x > 0 from which the data are FLU
constexpr std::size_t kMinReturns = 20;

}  // namespace

bool SignedAxes::IsIdentity() const {
  return source == std::array<int, 3>{0, 1, 2} && sign == std::array<double, 3>{1.0, 1.0, 1.0};
}

std::string SignedAxes::ToString() const {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += sign[i] < 0.0 ? '-' : '+';
    text += "xyz"[source[i]];
  }
  return text;
}

std::optional<SignedAxes> ParseAxes(std::string_view text) {
  if (text == "flu") return SignedAxes();
  if (text == "rdf") text = "+z-x-y";
  if (text.size() != 6) return std::nullopt;
  SignedAxes axes;
  std::array<bool, 3> used = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const char sign = text[2 * i];
    const char name = text[2 * i + 1];
    if ((sign != '+' && sign != '-') || name < 'x' || name > 'z') return std::nullopt;
    axes.sign[i] = sign == '-' ? -1.0 : 1.0;
    axes.source[i] = name - 'x';
    if (std::exchange(used[static_cast<std::size_t>(axes.source[i])], true)) return std::nullopt;
  }
  return axes;
}

AxesSource::AxesSource(std::unique_ptr<ScanSource> source, const std::string& axes)
    : source_(std::move(source)), ahead_(source_.get()), must_decide_(axes == "auto") {
  PassOn(Status::kScan, source_.get());  // what was found on opening
  if (must_decide_) return;
  const std::optional<SignedAxes> parsed = ParseAxes(axes);
  CHECK(parsed) << "input options were not checked: axes " << axes;
  axes_ = *parsed;
  reason_ = "as set";
}

ScanSource::Status AxesSource::Next(RadarScan* scan) {
  if (std::exchange(must_decide_, false)) {
    ahead_.Read(kMaxScans);
    Decide();
  }
  const Status status = PassOn(ahead_.Next(scan), source_.get());
  if (status != Status::kScan || axes_.IsIdentity()) return status;
  for (RadarReturn& ret : scan->returns) ret.position = axes_.Apply(ret.position);
  return Status::kScan;
}

ScanSource::Status AxesSource::Skip(int count) { return PassOn(ahead_.Skip(count), source_.get()); }

void AxesSource::Decide() {
  std::size_t num_returns = 0, num_x = 0, num_z = 0;
  double sum_y = 0.0, sum_z = 0.0;
  for (const RadarScan& scan : ahead_.held_back()) {
    for (const RadarReturn& ret : scan.returns) {
      if (!ret.position.allFinite() || ret.position.norm() < 1e-3) continue;
      ++num_returns;
      num_x += ret.position.x() > 0.0 ? 1 : 0;
      num_z += ret.position.z() > 0.0 ? 1 : 0;
      sum_y += std::abs(ret.position.y());
      sum_z += ret.position.z();
    }
  }
  const double total = static_cast<double>(std::max<std::size_t>(num_returns, 1));
  const double x_share = static_cast<double>(num_x) / total;
  const double z_share = static_cast<double>(num_z) / total;
  // Down there is little to see: the axis that points down has small values beside the range.
  const bool is_rdf = num_returns >= kMinReturns && z_share >= kMinForwardShare &&
                      x_share < kMaxForwardX && sum_y < 0.5 * sum_z;
  if (is_rdf) axes_ = *ParseAxes("rdf");
  reason_ = FormatText("%.0f %% of the returns of the first %d scans have x > 0, %.0f %% z > 0",
                       100.0 * x_share,
                       static_cast<int>(ahead_.held_back().size()),
                       100.0 * z_share);
}

SourceFacts AxesSource::Facts() const {
  SourceFacts facts = source_->Facts();
  facts.axes = axes_.ToString() + (reason_.empty() ? "" : " (" + reason_ + ")");
  return facts;
}

}  // namespace radive
