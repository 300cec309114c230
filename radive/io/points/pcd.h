// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes the bytes of a PCD file (0.7) apart: ascii, binary and binary_compressed. The table refers
// to `bytes` where they are binary. Fields called _ are padding; COUNT may be missing; VIEWPOINT is
// not applied. Where POINTS does not fit the payload, the payload is right, with a remark; records
// whose declared sizes do not fit, but would if every field were float32, are read so (the
// SNAIL-Radar tools write such files).
//
// False, with the header line or the byte and the expectation in `error`, for anything else.
bool ParsePcd(std::string_view bytes,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error);

}  // namespace radive
