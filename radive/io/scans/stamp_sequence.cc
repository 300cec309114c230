// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <utility>

#include "radive/io/bytes/stamp_text.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

struct Unit {
  const char* name;
  int exponent;  // of 10 [s]
};
constexpr std::array<Unit, 4> kUnits = {{{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}}};
constexpr std::size_t kSeconds = 0;
constexpr std::size_t kNanoseconds = 3;

// Intervals of radars [s]. Less than a factor 1000 apart: at most one unit fits.
constexpr double kShortestUsualInterval = 0.01;
constexpr double kLongestInterval = 1.0;
// ... with a margin, for the unit that numbers of this form have by default.
constexpr double kMargin = 2.5;
// The date of a stamp [s since 1970]: 1973 to 2286.
constexpr double kFirstDate = 1e8;
constexpr double kLastDate = 1e10;
// Longest interval that a unit may lead to [s].
constexpr double kLongestPause = 86400.0;
// Largest step between the numbers of scans in a row: a camera at 30 Hz beside a radar at 1 Hz.
constexpr double kLargestCounterStep = 30.0;
// Stands for stamps beyond kLatestStamp [ns].
constexpr std::int64_t kFarthest = 4'600'000'000'000'000'000;
// Share of the neighbours with one stamp above which precision was lost [-].
constexpr double kLostPrecision = 0.2;

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool IsWithin(double value, double least, double most) { return value >= least && value <= most; }

// What the numbers of a sequence have in common, whatever their unit.
struct Numbers {
  std::vector<double> values;
  bool are_whole = true;      // no decimal point, no exponent
  double median = 0.0;        // value
  double step = 0.0;          // median of those above 0; 0: there is none
  double even_share = 0.0;    // share of the steps that are the median step
  double repeat_share = 0.0;  // 0 for a single pair
};

Numbers Describe(std::vector<double> values, bool are_whole) {
  Numbers numbers;
  numbers.are_whole = are_whole;
  numbers.median = Median(values);
  std::vector<double> steps;
  std::size_t num_repeats = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step > 0.0) steps.push_back(step);
    if (step == 0.0) ++num_repeats;
  }
  numbers.step = Median(steps);
  const double num_steps = std::max(1.0, static_cast<double>(values.size()) - 1.0);
  if (num_repeats > 1) numbers.repeat_share = static_cast<double>(num_repeats) / num_steps;
  numbers.even_share =
      static_cast<double>(std::count_if(
          steps.begin(), steps.end(), [&](double step) { return step == numbers.step; })) /
      num_steps;
  numbers.values = std::move(values);
  return numbers;
}

struct Choice {
  std::size_t unit = kSeconds;
  bool has_date = false;
  bool has_interval = false;
};

// An interval counts more than a date: a counter of microseconds that began when the radar was
// switched on passes through numbers that are dates in seconds.
Choice ChooseUnit(const Numbers& numbers) {
  Choice best;
  best.unit = numbers.are_whole ? kNanoseconds : kSeconds;
  const std::size_t by_default = best.unit;
  int best_score = 0;
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    const double scale = std::pow(10.0, kUnits[i].exponent);
    const double margin = i == by_default ? kMargin : 1.0;
    Choice choice;
    choice.unit = i;
    choice.has_date = IsWithin(numbers.median * scale, kFirstDate, kLastDate) &&
                      numbers.step * scale <= kLongestPause;
    choice.has_interval = IsWithin(numbers.step * scale,
                                   kShortestUsualInterval / margin * (1.0 - 1e-9),
                                   kLongestInterval * margin);
    // Between stamps that repeat there are no intervals of scans.
    const bool is_interval = numbers.repeat_share <= kLostPrecision;
    const int score = (choice.has_date ? (is_interval ? 1 : 2) : 0) +
                      (choice.has_interval ? (is_interval ? 2 : 1) : 0);
    if (score <= best_score) continue;
    best = choice;
    best_score = score;
  }
  return best;
}

// 0, 1, 2 or 12, 15, 18: numbers of scans or of camera images.
bool IsCounter(const Numbers& numbers, const Choice& choice) {
  if (choice.has_date || numbers.even_share < 0.5 || numbers.values.size() < 3) return false;
  const bool are_whole = std::all_of(
      numbers.values.begin(), numbers.values.end(), [](double v) { return v == std::floor(v); });
  if (!are_whole || !IsWithin(numbers.step, 1.0, kLargestCounterStep)) return false;
  // Written with a point they may as well be seconds, unless they number the scans.
  return numbers.are_whole || (numbers.step == 1.0 && numbers.values.front() <= 1.0);
}

// Spreads the scans that share a stamp evenly up to the next one. False when that leaves no
// plausible interval.
bool SpreadRepeats(std::vector<std::int64_t>* stamps_ns) {
  struct Run {
    std::size_t begin, size;
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < stamps_ns->size(); ++i) {
    if (i > 0 && (*stamps_ns)[i] == (*stamps_ns)[i - 1]) {
      ++runs.back().size;
    } else {
      runs.push_back({i, 1});
    }
  }
  std::vector<double> intervals;  // of the runs between two stamps [ns]
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    const double step =
        static_cast<double>((*stamps_ns)[runs[k + 1].begin] - (*stamps_ns)[runs[k].begin]);
    // The first run may have begun anywhere between two stamps.
    if ((k > 0 || runs.size() == 2) && step > 0.0) {
      intervals.push_back(step / static_cast<double>(runs[k].size));
    }
  }
  const double usual = Median(intervals);
  if (!IsWithin(usual * 1e-9, kShortestUsualInterval / kMargin, kLongestInterval * kMargin)) {
    return false;
  }
  const std::vector<std::int64_t> stored = *stamps_ns;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const bool has_next = k + 1 < runs.size();
    const double step =
        has_next ? static_cast<double>(stored[runs[k + 1].begin] - stored[runs[k].begin]) : 0.0;
    const double size = static_cast<double>(runs[k].size);
    const bool is_whole_run = has_next && step > 0.0 && k > 0;
    const double interval = is_whole_run ? step / size : usual;
    for (std::size_t j = 0; j < runs[k].size; ++j) {
      const double position = static_cast<double>(j);
      const double shift =
          k == 0 && has_next ? step - (size - position) * interval : position * interval;
      (*stamps_ns)[runs[k].begin + j] = stored[runs[k].begin] + std::llround(shift);
    }
  }
  return true;
}

void UseRate(const Numbers& numbers, double rate, StampSequence* sequence) {
  sequence->unit = "counter";
  sequence->rate_is_used = true;
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    // Numbers that are left out are scans that are not there.
    const double position = numbers.step > 0.0
                                ? (numbers.values[i] - numbers.values.front()) / numbers.step
                                : static_cast<double>(i);
    sequence->stamps_ns.push_back(StampAt(position, rate));
  }
}

}  // namespace

std::string AssumedRateText() {
  return FormatText("%g scans per second are assumed; set input.rate", kAssumedRate);
}

std::int64_t StampAt(double position, double rate) {
  constexpr double kLatest = 4.6e18;
  const double stamp_ns = position * 1e9 / (rate > 0.0 ? rate : kAssumedRate);
  return std::llround(std::clamp(stamp_ns, -kLatest, kLatest));
}

std::optional<std::int64_t> ParseDate(std::string_view text) {
  std::array<int, 6> parts = {};  // year, month, day, hour, minute, second
  if (!text.empty() && text.back() == 'Z') text.remove_suffix(1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t most = i == 0 ? 4 : 2;
    std::size_t size = 0;
    while (size < most && size < text.size() && text[size] >= '0' && text[size] <= '9') ++size;
    if (size == 0 || (i == 0 && size < most)) return std::nullopt;
    parts[i] = static_cast<int>(*ParseCount(text.substr(0, size)));
    text.remove_prefix(size);
    if (i + 1 == parts.size()) break;
    if (text.empty() || std::string_view(" T-_/:").find(text.front()) == std::string_view::npos) {
      return std::nullopt;
    }
    text.remove_prefix(1);
  }
  std::int64_t fraction_ns = 0;
  if (!text.empty()) {
    if ((text.front() != '.' && text.front() != ',') || text.size() < 2) return std::nullopt;
    text.remove_prefix(1);
    if (text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const std::optional<std::int64_t> fraction = ParseStamp("0." + std::string(text));
    if (!fraction) return std::nullopt;
    fraction_ns = *fraction;
  }
  const bool is_date = parts[0] >= 1973 && parts[0] < 2262 && IsWithin(parts[1], 1, 12) &&
                       IsWithin(parts[2], 1, 31) && parts[3] < 24 && parts[4] < 60 &&
                       parts[5] <= 60;
  if (!is_date) return std::nullopt;
  std::tm date = {};
  date.tm_year = parts[0] - 1900;
  date.tm_mon = parts[1] - 1;
  date.tm_mday = parts[2];
  date.tm_hour = parts[3];
  date.tm_min = parts[4];
  date.tm_sec = parts[5];
  return static_cast<std::int64_t>(timegm(&date)) * 1'000'000'000 + fraction_ns;
}

std::optional<StampSequence> ReadStampSequence(const std::vector<std::string_view>& texts,
                                               double rate,
                                               std::size_t* bad) {
  StampSequence sequence;
  if (!texts.empty() && ParseDate(texts.front())) {
    sequence.unit = "dates";
    for (*bad = 0; *bad < texts.size(); ++*bad) {
      const std::optional<std::int64_t> stamp = ParseDate(texts[*bad]);
      if (!stamp) return std::nullopt;
      sequence.stamps_ns.push_back(*stamp);
    }
    return sequence;
  }
  std::vector<double> values;
  bool are_whole = true;
  for (*bad = 0; *bad < texts.size(); ++*bad) {
    const std::optional<double> value = ParseDouble(texts[*bad]);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values.push_back(*value);
    are_whole = are_whole && texts[*bad].find_first_of(".eE") == std::string_view::npos;
  }
  const Numbers numbers = Describe(std::move(values), are_whole);
  const bool is_frozen = texts.size() > 2 && numbers.step == 0.0 && numbers.repeat_share == 1.0;
  const Choice choice = ChooseUnit(numbers);
  if (is_frozen || IsCounter(numbers, choice)) {
    UseRate(numbers, rate, &sequence);
    sequence.doubt = is_frozen ? "all stamps are " + std::string(texts.front())
                               : "the numbers (" + std::string(texts[0]) + ", " +
                                     std::string(texts[1]) + ", ...) count the scans";
    return sequence;
  }
  const Unit unit = kUnits[choice.unit];
  sequence.unit = unit.name;
  for (*bad = 0; *bad < texts.size(); ++*bad) {
    const std::optional<std::int64_t> stamp = ParseStamp(texts[*bad], unit.exponent);
    // Beyond the range of stamps it is one of the bad ones that drives have.
    const std::int64_t farthest = numbers.values[*bad] < 0.0 ? -kFarthest : kFarthest;
    sequence.stamps_ns.push_back(stamp.value_or(farthest));
  }
  if (numbers.repeat_share > kLostPrecision) {
    if (SpreadRepeats(&sequence.stamps_ns)) {
      sequence.doubt =
          "stamps repeat, as if their precision was lost; the scans between two "
          "different stamps are spread evenly";
    } else {
      sequence.stamps_ns.clear();
      for (std::size_t i = 0; i < texts.size(); ++i) {
        sequence.stamps_ns.push_back(StampAt(static_cast<double>(i), rate));
      }
      sequence.unit = "counter";
      sequence.rate_is_used = true;
      sequence.doubt = "most stamps repeat, as if their precision was lost";
    }
  } else if (numbers.step > 0.0 && !choice.has_interval) {
    const double interval = numbers.step * std::pow(10.0, unit.exponent);
    sequence.doubt = "read as " + sequence.unit + " the stamps lie " +
                     FormatText("%.4g", interval) +
                     " s apart, and no other unit fits a radar better";
  }
  return sequence;
}

}  // namespace radive
