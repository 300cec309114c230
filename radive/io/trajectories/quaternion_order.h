// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// True when the rotations, read from columns qx qy qz qw, would follow the motion far better as
// qw qx qy qz: vehicles move about the same way in their own axes wherever they turn. False where
// the motion does not tell, as straight ahead.
bool HasScalarFirst(const RecordedTrajectory& poses);

}  // namespace radive
