// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/studies/run_record.h"
#include "radive/studies/study.h"

namespace radive {

// A middle value and its 95 % interval, where there are enough runs for one.
struct Estimate {
  std::optional<double> value;
  std::optional<double> low;
  std::optional<double> high;
};

// A row of summary.csv: one metric of one variant, over the runs of one sequence or of all. The
// columns are those of docs/studies.md.
struct SummaryRow {
  std::string variant;
  std::string sequence;  // "*": all
  std::string metric;    // ate_t | ate_r | rpe_t | rpe_r
  int runs = 0;          // that were to give a figure
  int ok = 0;            // that did
  std::optional<double> median, q25, q75, min, max;

  // Against the first variant, run by run: same sequence, same seed, as many scans.
  int pairs = 0;
  Estimate difference;
  Estimate ratio;
  Estimate ratio_over_drives;  // value as in `ratio`; interval with drives drawn as well
};

// All rows in the order of the study: variants, sequences ("*" first), metrics.
std::vector<SummaryRow> Summarise(const Study& study, const std::vector<RunRecord>& records);

std::string SummaryCsv(const std::vector<SummaryRow>& rows);

// A table of variants x sequences with median ATE_t / ATE_r, and the ratios to the first variant.
std::string SummaryMarkdown(const Study& study, const std::vector<SummaryRow>& rows);

}  // namespace radive
