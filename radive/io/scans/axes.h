// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "radive/io/scans/scan_lookahead.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// A signed permutation of axes: from the axes of the data to FLU.
struct SignedAxes {
  std::array<int, 3> source = {0, 1, 2};  // the data's axis that becomes x, y, z
  std::array<double, 3> sign = {1.0, 1.0, 1.0};

  Eigen::Vector3d Apply(const Eigen::Vector3d& stored) const {
    return {sign[0] * stored[source[0]], sign[1] * stored[source[1]], sign[2] * stored[source[2]]};
  }
  bool IsIdentity() const;
  std::string ToString() const;  // "+x+y+z"
};

// Reads "+x+y+z", "+z-x-y" and so on: which axis of the data points forward, left and up; "flu" is
// +x+y+z, "rdf" (right, down, forward) +z-x-y. Nothing for anything else. Mirrored axes are
// allowed: some sensors have them.
std::optional<SignedAxes> ParseAxes(std::string_view text);

// Turns the positions of `source` into FLU; range rates do not depend on axes. With input.axes:
// auto the first kMaxScans scans decide, before the first of them is delivered: what a forward
// radar sees has x > 0 in FLU, and z > 0 in the right-down-forward frame of cameras and of the
// Oculii sensors. Anything that is not clearly the latter is left as it is.
class AxesSource : public ScanSource {
 public:
  static constexpr std::size_t kMaxScans = 10;

  // `axes` as input.axes has it, and valid.
  AxesSource(std::unique_ptr<ScanSource> source, const std::string& axes);

  Status Next(RadarScan* scan) override;
  Status Skip(int count) override;
  std::string Description() const override { return source_->Description(); }
  std::optional<int> NumScans() const override { return source_->NumScans(); }
  SourceFacts Facts() const override;

 private:
  void Decide();

  const std::unique_ptr<ScanSource> source_;
  ScanLookahead ahead_;
  bool must_decide_ = false;
  SignedAxes axes_;
  std::string reason_;
};

}  // namespace radive
