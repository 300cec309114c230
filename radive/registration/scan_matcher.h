// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "radive/factors/condensed_ndt_cost.h"
#include "radive/geometry/rigid3.h"

namespace ceres {
class Problem;
}  // namespace ceres

namespace radive {

// What a method of registration makes of scan and submap for one association: the terms of the
// objective that come from the data. Poses are relative to the origin of the matcher.
class ScanMatch {
 public:
  virtual ~ScanMatch() = default;

  // Adds its residual blocks on `pose` (a pose block); they stay its own.
  virtual void AddTo(ceres::Problem* problem, double* pose) const = 0;

  // Its cost, derivatives and scatter at `pose`.
  virtual NdtQuadratic Quadratic(const double* pose) const = 0;

  // The constant part of the cost that Ceres sees.
  virtual double offset() const { return 0.0; }

  virtual int num_pairs() const = 0;           // pairs of scan and submap
  virtual int num_scan_gaussians() const = 0;  // scan Gaussians that have a pair at all
};

// A method of registration: finds the pairs between one scan and one submap.
class ScanMatcher {
 public:
  virtual ~ScanMatcher() = default;

  // Pairs at `T_submap_radar`, which is within `slack` of the truth [m].
  virtual std::unique_ptr<ScanMatch> Associate(const Rigid3& T_submap_radar, double slack) = 0;

  // Whether other pairs are likely at `to` than at `from`, where pairs were found.
  virtual bool PairsDiffer(const Rigid3& from, const Rigid3& to) const = 0;

  // Pairs hold for one step only: each is followed by a new association.
  virtual bool associates_each_step() const = 0;
};

}  // namespace radive
