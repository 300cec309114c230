// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "radive/geometry/rigid3.h"
#include "radive/util/recent_median.h"

namespace radive {

// Tells registrations that contradict the motion: a scan that fits the submap at a wrong pose (one
// of another place, a turned one, one that a lorry fills) is registered as well as any other.
//
// The innovation, registered against predicted pose, is held against the median of the scans
// before. A scan that is far beyond it is refused, and the drive goes on at its prediction. When
// the next scan contradicts the prediction too, but follows from the refused pose by the predicted
// motion, then both were right: it was the pose before that was wrong, or the vehicle that was
// quick. What is usual is then learned anew.
class InnovationGate {
 public:
  // `gate`: largest innovation, in multiples of the median; 0 lets everything pass.
  explicit InnovationGate(double gate) : gate_(gate) {}

  // Takes in a registered scan: empty when it is believed, else what contradicts.
  // `T_world_last`: pose of the scan before, from which the motion was predicted.
  // `num_intervals`: time since then, in usual intervals between scans.
  std::string Check(const Rigid3& T_world_last,
                    const Rigid3& T_world_predicted,
                    const Rigid3& T_world_registered,
                    double num_intervals);

  // Where the scan before the last one checked really was, when that follows from the last one.
  const std::optional<Rigid3>& T_world_corrected() const { return T_world_corrected_; }

  // After a scan that was not registered.
  void Forget() { T_world_refused_.reset(); }

 private:
  struct Innovation {
    double rotation;     // [rad]
    double translation;  // [m]
  };
  static Innovation Between(const Rigid3& T_predicted, const Rigid3& T_registered);
  // What is believed of a scan one usual interval after the last.
  Innovation Limit() const;

  const double gate_;
  RecentMedian rotations_, translations_;  // innovations of one interval [rad], [m]
  std::optional<Rigid3> T_world_refused_;
  std::optional<Rigid3> T_world_corrected_;
  int num_refused_ = 0;  // one after the other
};

}  // namespace radive
