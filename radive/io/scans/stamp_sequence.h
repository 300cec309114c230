// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// Rate that is assumed where the data have no stamps and input.rate is not set [Hz].
constexpr double kAssumedRate = 10.0;

// "10 scans per second are assumed; set input.rate".
std::string AssumedRateText();

// Stamp of the scan at `position` of a drive without stamps [ns]; `rate` in Hz, 0: kAssumedRate.
std::int64_t StampAt(double position, double rate);

// The stamps of a drive as written, in nanoseconds.
struct StampSequence {
  std::vector<std::int64_t> stamps_ns;
  std::string unit;           // "ns", "us", "ms", "s", "dates", "counter" (the numbers are no time)
  bool rate_is_used = false;  // the time base is a rate instead of stamps
  std::string doubt;          // what a user should know; empty: nothing
};

// A calendar date and time of day in UTC [ns since 1970]: "2011-09-26 13:02:25.594360375", also
// with T between them, with / or : or - or _ as separators, and with Z behind. Nothing for anything
// else.
std::optional<std::int64_t> ParseDate(std::string_view text);

// Decides the unit of all `texts` together, never value by value. Evidence is the date that the
// median stamp stands for (9 to 19 digits that are a time between 1973 and 2286), and the median
// interval, which of a radar is 0.01 to 1 s. Where neither tells, numbers with a decimal point or
// an exponent are seconds, whole numbers nanoseconds, and `doubt` says so. Whole numbers that count
// up in small even steps are positions, which `rate` [Hz] makes times (0: kAssumedRate). Where many
// neighbours share a stamp (precision was lost), the scans between two stamps are spread evenly.
// Nothing, with the index of the first text that is no stamp in `bad`, when there is one.
std::optional<StampSequence> ReadStampSequence(const std::vector<std::string_view>& texts,
                                               double rate,
                                               std::size_t* bad);

}  // namespace radive
