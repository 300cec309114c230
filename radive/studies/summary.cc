// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "radive/studies/bootstrap.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

struct Metric {
  const char* name;
  std::optional<double> RunScores::*value;
};
constexpr Metric kMetrics[] = {{"ate_t", &RunScores::ate_t},
                               {"ate_r", &RunScores::ate_r},
                               {"rpe_t", &RunScores::rpe_t},
                               {"rpe_r", &RunScores::rpe_r}};

using RecordKey = std::tuple<std::string, std::string, int>;  // variant, sequence, seed
using Records = std::map<RecordKey, const RunRecord*>;

// A ratio to an error of zero says nothing.
constexpr double kLeastError = 1e-12;

// The figures of one variant and metric, a group for each sequence.
struct Figures {
  int runs = 0;
  std::vector<double> values;
  std::vector<std::vector<double>> differences;
  std::vector<std::vector<double>> log_ratios;
};

void AddSequence(const Study& study,
                 const Records& records,
                 const std::string& variant,
                 const std::string& sequence,
                 const Metric& metric,
                 Figures* figures) {
  std::vector<double> differences;
  std::vector<double> log_ratios;
  const auto find = [&](const std::string& name, int seed) {
    const auto found = records.find({name, sequence, seed});
    return found == records.end() ? nullptr : found->second;
  };
  for (const int seed : study.seeds) {
    const RunRecord* const record = find(variant, seed);
    if (record == nullptr || record->status == "absent") continue;
    ++figures->runs;
    const std::optional<double> value = record->scores.*metric.value;
    if (!value) continue;
    figures->values.push_back(*value);
    const RunRecord* const twin = find(study.variants.front().name, seed);
    if (twin == nullptr || twin->scans != record->scans) continue;
    const std::optional<double> other = twin->scores.*metric.value;
    if (!other) continue;
    differences.push_back(*value - *other);
    log_ratios.push_back(std::log(std::max(*value, kLeastError)) -
                         std::log(std::max(*other, kLeastError)));
  }
  figures->differences.push_back(std::move(differences));
  figures->log_ratios.push_back(std::move(log_ratios));
}

std::vector<double> Flat(const std::vector<std::vector<double>>& groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

Estimate MedianOf(const std::vector<std::vector<double>>& groups, Draw draw) {
  Estimate estimate;
  const std::vector<double> all = Flat(groups);
  if (all.empty()) return estimate;
  estimate.value = Quantile(all, 0.5);
  if (const auto interval = BootstrapMedian(groups, draw)) {
    estimate.low = interval->low;
    estimate.high = interval->high;
  }
  return estimate;
}

Estimate Exponential(Estimate estimate) {
  for (std::optional<double>* number : {&estimate.value, &estimate.low, &estimate.high}) {
    if (*number) *number = std::exp(**number);
  }
  return estimate;
}

SummaryRow RowOf(const std::string& variant,
                 const std::string& sequence,
                 const Metric& metric,
                 const Figures& figures) {
  SummaryRow row;
  row.variant = variant;
  row.sequence = sequence;
  row.metric = metric.name;
  row.runs = figures.runs;
  row.ok = static_cast<int>(figures.values.size());
  if (!figures.values.empty()) {
    row.median = Quantile(figures.values, 0.5);
    row.q25 = Quantile(figures.values, 0.25);
    row.q75 = Quantile(figures.values, 0.75);
    row.min = Quantile(figures.values, 0.0);
    row.max = Quantile(figures.values, 1.0);
  }
  row.pairs = static_cast<int>(Flat(figures.differences).size());
  row.difference = MedianOf(figures.differences, Draw::kWithinGroups);
  row.ratio = Exponential(MedianOf(figures.log_ratios, Draw::kWithinGroups));
  row.ratio_over_drives = Exponential(MedianOf(figures.log_ratios, Draw::kGroupsAndWithin));
  return row;
}

std::string NumberCell(const std::optional<double>& value) {
  return value ? ShortText(*value) : "";
}

std::string Fixed(double value, int digits) { return FormatText("%.*f", digits, value); }

std::string RatioText(const Estimate& ratio) {
  if (!ratio.value) return "-";
  std::string text = Fixed(*ratio.value, 3);
  if (ratio.low) text += " (" + Fixed(*ratio.low, 3) + " .. " + Fixed(*ratio.high, 3) + ")";
  return text;
}

const SummaryRow* Find(const std::vector<SummaryRow>& rows,
                       const std::string& variant,
                       const std::string& sequence,
                       const std::string& metric) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.variant == variant && row.sequence == sequence && row.metric == metric;
  });
  return found == rows.end() ? nullptr : &*found;
}

// "0.274 / 1.10", with the number of runs where some gave no figure.
std::string MedianText(const std::vector<SummaryRow>& rows,
                       const std::string& variant,
                       const std::string& sequence) {
  const SummaryRow* const ate_t = Find(rows, variant, sequence, "ate_t");
  const SummaryRow* const ate_r = Find(rows, variant, sequence, "ate_r");
  if (ate_t == nullptr || !ate_t->median || !ate_r->median) return "-";
  std::string text = Fixed(*ate_t->median, 3) + " / " + Fixed(*ate_r->median, 2);
  if (ate_t->ok < ate_t->runs) {
    text += " (" + std::to_string(ate_t->ok) + " of " + std::to_string(ate_t->runs) + ")";
  }
  return text;
}

}  // namespace

std::vector<SummaryRow> Summarise(const Study& study, const std::vector<RunRecord>& records) {
  Records by_key;
  for (const RunRecord& record : records) {
    by_key[{record.variant, record.sequence, record.seed}] = &record;
  }
  std::vector<SummaryRow> rows;
  for (const StudyVariant& variant : study.variants) {
    std::vector<SummaryRow> rows_of_sequences;
    for (const Metric& metric : kMetrics) {
      Figures all;
      for (const StudySequence& sequence : study.sequences) {
        AddSequence(study, by_key, variant.name, sequence.name, metric, &all);
      }
      rows.push_back(RowOf(variant.name, "*", metric, all));
    }
    for (const StudySequence& sequence : study.sequences) {
      for (const Metric& metric : kMetrics) {
        Figures one;
        AddSequence(study, by_key, variant.name, sequence.name, metric, &one);
        rows_of_sequences.push_back(RowOf(variant.name, sequence.name, metric, one));
      }
    }
    rows.insert(rows.end(), rows_of_sequences.begin(), rows_of_sequences.end());
  }
  return rows;
}

std::string SummaryCsv(const std::vector<SummaryRow>& rows) {
  std::string text =
      "variant,sequence,metric,runs,ok,median,q25,q75,min,max,pairs,difference,difference_low,"
      "difference_high,ratio,ratio_low,ratio_high,ratio_low_drives,ratio_high_drives\n";
  for (const SummaryRow& row : rows) {
    text += row.variant + "," + row.sequence + "," + row.metric + "," + std::to_string(row.runs) +
            "," + std::to_string(row.ok);
    for (const auto& value : {row.median, row.q25, row.q75, row.min, row.max}) {
      text += "," + NumberCell(value);
    }
    text += "," + std::to_string(row.pairs);
    for (const auto& value : {row.difference.value,
                              row.difference.low,
                              row.difference.high,
                              row.ratio.value,
                              row.ratio.low,
                              row.ratio.high,
                              row.ratio_over_drives.low,
                              row.ratio_over_drives.high}) {
      text += "," + NumberCell(value);
    }
    text += "\n";
  }
  return text;
}

std::string SummaryMarkdown(const Study& study, const std::vector<SummaryRow>& rows) {
  const std::string first = study.variants.front().name;
  std::string text = "# " + study.name + "\n\nMedians of ATE_t m / ATE_r deg over " +
                     std::to_string(study.seeds.size()) +
                     (study.seeds.size() == 1 ? " seed" : " seeds") + "; ratios to " +
                     study.variants.front().label +
                     ", run by run: median and 95 % interval, bootstrap within sequences.\n\n";
  std::string header = "| variant |";
  std::string line = "|---|";
  for (const StudySequence& sequence : study.sequences) {
    header += " " + sequence.name + " |";
    line += "---|";
  }
  text += header + " ATE_t, ratio | ATE_r, ratio | pairs |\n" + line + "---|---|---|\n";
  for (const StudyVariant& variant : study.variants) {
    text += "| " + variant.label + " |";
    for (const StudySequence& sequence : study.sequences) {
      text += " " + MedianText(rows, variant.name, sequence.name) + " |";
    }
    const SummaryRow* const ate_t = Find(rows, variant.name, "*", "ate_t");
    const SummaryRow* const ate_r = Find(rows, variant.name, "*", "ate_r");
    const bool is_first = variant.name == first;
    text += " " + (is_first ? "1" : RatioText(ate_t->ratio)) + " | " +
            (is_first ? "1" : RatioText(ate_r->ratio)) + " | " + std::to_string(ate_t->pairs) +
            " |\n";
  }
  return text;
}

}  // namespace radive
