// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/stamp_sequence.h"

namespace radive {

// The stamps in the names of the scans of a drive, decided from all `stems` (names without their
// extension) together:
//
//   1700000000123456789            18 or 19 digits ns, 15 or 16 us, 12 or 13 ms, 10 s since 1970
//   1700000000.123456              seconds with a fraction
//   1700000000_123456789           seconds and ns (with up to six digits: us, up to three: ms)
//   2023-11-14-22-13-20.123, 20231114_221320_123   date and time of day
//
// with anything around them ("radar_<ns>", "n015-2018-07-24-11-22-45+0800__RADAR_FRONT__<us>",
// "000012_<ns>"). Of several numbers that may be the stamp that counts which differs from name to
// name. Numbers with leading zeros are positions. Nothing when the names hold no stamps, or one of
// them holds none; `odd` is then a name without a stamp among others that have one, if there is
// such a name.
std::optional<StampSequence> StampsOfNames(const std::vector<std::string>& stems,
                                           std::optional<std::size_t>* odd);

}  // namespace radive
