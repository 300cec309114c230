// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/innovation_gate.h"

#include <algorithm>

#include "radive/util/angle_units.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// What is believed however regular the drive was so far: a vehicle that starts to move or to turn.
constexpr double kSureRotation = 0.02;    // [rad]
constexpr double kSureTranslation = 0.2;  // [m]

// Scans that are refused one after the other at most: what the prediction goes on from gets older.
constexpr int kMostRefused = 3;

}  // namespace

InnovationGate::Innovation InnovationGate::Between(const Rigid3& T_predicted,
                                                   const Rigid3& T_registered) {
  return {RotationVector(T_predicted.rotation.conjugate() * T_registered.rotation).norm(),
          (T_registered.translation - T_predicted.translation).norm()};
}

InnovationGate::Innovation InnovationGate::Limit() const {
  return {std::max(kSureRotation, gate_ * rotations_.Value()),
          std::max(kSureTranslation, gate_ * translations_.Value())};
}

std::string InnovationGate::Check(const Rigid3& T_world_last,
                                  const Rigid3& T_world_predicted,
                                  const Rigid3& T_world_registered,
                                  double num_intervals) {
  T_world_corrected_.reset();
  if (gate_ == 0.0) return "";
  const double intervals = std::max(1.0, num_intervals);
  const Innovation innovation = Between(T_world_predicted, T_world_registered);
  const bool is_known = rotations_.is_known();
  const Innovation limit = is_known ? Limit() : Innovation{};
  rotations_.Add(innovation.rotation / intervals);
  translations_.Add(innovation.translation / intervals);
  const auto is_believed = [&limit, intervals](const Innovation& candidate) {
    return candidate.rotation <= intervals * limit.rotation &&
           candidate.translation <= intervals * limit.translation;
  };
  if (is_known && !is_believed(innovation) && num_refused_ < kMostRefused) {
    const Rigid3 T_last_predicted = T_world_last.Inverse() * T_world_predicted;
    if (!T_world_refused_ ||
        !is_believed(Between(*T_world_refused_ * T_last_predicted, T_world_registered))) {
      ++num_refused_;
      T_world_refused_ = T_world_registered;
      return FormatText(
          "contradicts the motion: %.2f deg and %.2f m from the prediction, at most %.2f and %.2f "
          "after the scans before",
          Degrees(innovation.rotation),
          innovation.translation,
          Degrees(intervals * limit.rotation),
          intervals * limit.translation);
    }
    T_world_corrected_ = T_world_refused_;
    // What was usual no longer is: as where a slow turn makes the prediction by Doppler poor.
    rotations_.Clear();
    translations_.Clear();
  }
  num_refused_ = 0;
  T_world_refused_.reset();
  return "";
}

}  // namespace radive
