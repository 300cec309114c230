// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// How the surface of the neural map becomes a submap.
struct SdfSubmapOptions {
  enum class Source {
    kPoints,   // the surface points themselves (paper)
    kReturns,  // the keyframes' returns in the cells of surface points
  };
  Source source = Source::kPoints;

  // A keyframe is trained beside registration and enters the submap so many scans later (or with
  // the next keyframe, if that is sooner): by scan index, never by timing.
  int handover_scans = 2;

  // Whether a raw submap may stand in for the surface: on the first keyframes, and for good where
  // the map has next to no surface. Off, the submap is the surface of the last keyframe, however
  // little that is (paper).
  bool bypass = true;

  // Bypass: after so many keyframes, on which the submap is raw, it stays raw when the points seen
  // have fewer neighbours than this (median).
  int bypass_keyframes = 5;
  double bypass_neighbors = 5.0;

  // Share by which the Gaussian of a point is flattened along the normal, for it stands for more
  // than one return: S' = (I - a n n^T) S (I - a n n^T) [-].
  double flatten = 0.3;

  // Whether what is learned is kept for a map of the drive (Odometry::TakeSurfaces), and the
  // spacing of its grid [m], 0: none. Not settings: whoever writes maps sets them.
  bool record = false;
  double record_grid_spacing = 0.0;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("sdf_submap", *this, error); }
};

}  // namespace radive
