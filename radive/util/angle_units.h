// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Inside the library angles are radians; these are for what people read.
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double Degrees(double radians) { return radians * (180.0 / kPi); }
inline constexpr double Radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace radive
