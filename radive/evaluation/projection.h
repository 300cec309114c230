// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/geometry/matrix_pose.h"

namespace radive {

enum class Plane { kNone, kXy, kXz, kYz };

// Projects poses into a coordinate plane: the coordinate normal to it becomes 0, and of the
// rotation only the Euler angle about the normal is left, from R = Rz(yaw) Ry(pitch) Rx(roll):
// xy keeps the yaw, xz the pitch (in [-pi/2, pi/2]), yz the roll. In gimbal lock the yaw is 0.
void ProjectToPlane(Plane plane, std::vector<MatrixPose>* poses);

}  // namespace radive
