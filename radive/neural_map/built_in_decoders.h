// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/neural_map/sdf_decoder.h"

namespace radive {

// The decoders that configs/decoders/ ships, compiled in: feature dimension 4 (16 hidden units) or
// 8 (32), for neural points with their z axis along the surface normal or with the axes of the
// world. Made by radive_train_decoder; their comments say how.
// With the axes of the world: for feature dimension 4 alone.
bool HasBuiltInDecoder(int feature_dim, bool has_normals);

SdfDecoder BuiltInDecoder(int feature_dim, bool has_normals);

}  // namespace radive
