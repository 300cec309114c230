// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Why returns of a scan do not reach registration, in the order of the filters: a return counts
// where it is dropped first. What is left, and these, sum up to the returns of the scan.
struct DropCounts {
  int not_finite = 0;      // position not finite
  int no_doppler = 0;      // Doppler not finite, in a scan that has Doppler
  int out_of_range = 0;    // preprocessing.min_range, max_range
  int out_of_view = 0;     // its angles
  int no_velocity = 0;     // nothing tells what moves: the scan has Doppler, but no ego velocity
  int moving = 0;          // Doppler of no static return
  int occluded = 0;        // behind other returns
  int behind_nearest = 0;  // by the azimuth bins

  int Sum() const {
    return not_finite + no_doppler + out_of_range + out_of_view + no_velocity + moving + occluded +
           behind_nearest;
  }
};

}  // namespace radive
