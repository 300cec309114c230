// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "radive/io/scans/scan_source.h"
#include "radive/util/random.h"

namespace radive {

// Leaves each return of `source` out with probability `share` [-], to see how much a result depends
// on single returns. What is left out of a scan follows from the seed, its stamp and its radar
// alone, so neither the scans before it nor their order matter.
class ThinnedSource : public ScanSource {
 public:
  ThinnedSource(std::unique_ptr<ScanSource> source, double share, int seed)
      : source_(std::move(source)), share_(share), seed_(static_cast<std::uint64_t>(seed)) {}

  Status Next(RadarScan* scan) override {
    const Status status = PassOn(source_->Next(scan), source_.get());
    if (status != Status::kScan) return status;
    Random random(StreamSeed(*scan));
    const auto is_dropped = [&](const RadarReturn&) { return random.Uniform() < share_; };
    scan->returns.erase(std::remove_if(scan->returns.begin(), scan->returns.end(), is_dropped),
                        scan->returns.end());
    return status;
  }
  Status Skip(int count) override { return PassOn(source_->Skip(count), source_.get()); }
  std::string Description() const override { return source_->Description(); }
  std::optional<int> NumScans() const override { return source_->NumScans(); }
  SourceFacts Facts() const override { return source_->Facts(); }

 private:
  // Each part passes through the generator, so that neighbouring seeds and stamps have nothing in
  // common.
  std::uint64_t StreamSeed(const RadarScan& scan) const {
    std::uint64_t seed = Random(seed_).Bits();
    seed = Random(seed ^ static_cast<std::uint64_t>(scan.stamp_ns)).Bits();
    return Random(seed ^ static_cast<std::uint64_t>(scan.radar)).Bits();
  }

  const std::unique_ptr<ScanSource> source_;
  const double share_;
  const std::uint64_t seed_;
};

}  // namespace radive
