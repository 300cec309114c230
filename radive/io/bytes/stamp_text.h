// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace radive {

// Latest stamp, and with a minus the earliest [ns], 146 years from zero: any two can be subtracted.
constexpr std::int64_t kLatestStamp = std::int64_t{1} << 62;

// A stamp as written in a file, without the detour over a double that would cost 0.2 us:
// "1706001762.099999905", "1.706001762099999905e+09", "-0.5". Rounded to the nearest nanosecond,
// halves away from zero. std::nullopt when `text` is no decimal number or beyond kLatestStamp.
// `unit_exponent`: the text counts units of 10^unit_exponent seconds (0: seconds, -9: ns).
std::optional<std::int64_t> ParseStamp(std::string_view text, int unit_exponent = 0);

// True for stamps that must be nanoseconds: more than 15 digits and neither point nor exponent.
bool LooksLikeNanoseconds(std::string_view text);

// Seconds with nine decimals: 1706001762099999905 -> "1706001762.099999905".
std::string FormatStamp(std::int64_t stamp_ns);

}  // namespace radive
