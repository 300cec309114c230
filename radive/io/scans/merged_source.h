// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "radive/io/scans/scan_source.h"

namespace radive {

// Several radars of one drive as one stream: their scans in the order of their stamps. Of scans
// with the same stamp that of the source named first comes first. Each radar has its own clock
// offset in its source; a radar whose drive ends earlier just falls silent. One scan of each source
// is held.
class MergedSource : public ScanSource {
 public:
  // A source, and the number that its scans get.
  struct Radar {
    std::unique_ptr<ScanSource> source;
    int number = 0;
  };

  // At least one radar.
  explicit MergedSource(std::vector<Radar> radars);

  Status Next(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;  // of the first source

 private:
  struct Input {
    std::unique_ptr<ScanSource> source;
    int number = 0;
    RadarScan next;  // with status kScan
    Status status = Status::kScan;
    bool is_read = false;  // `next` and `status` stand for what comes next
  };

  // Fills the input's `next`; false after an error.
  bool Read(Input* input);
  void CompareClocks();

  std::vector<Input> inputs_;
  bool has_compared_ = false;
};

}  // namespace radive
