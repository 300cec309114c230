// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace radive {

// The points of a scan in the plane, spread out and weighted for DisplacementVotes.
struct VotingPoints {
  std::vector<Eigen::Vector2d> positions;  // radar at the origin [m]
  std::vector<double> weights;             // 1 / number of points nearby, itself included [-]
};

// SpreadOut() with their weights.
VotingPoints MakeVotingPoints(const std::vector<Eigen::Vector2d>& points, std::size_t max_count);

// How well two scans of one radar agree, in the plane, at every displacement of the radar between
// them: each pair of a point before and a point after votes for the displacement that lays them on
// one another, once for each of a range of turns. The votes for a displacement are about the number
// of objects that meet. Needs neither a first guess nor Doppler, and prefers no direction: swapping
// the scans turns the sign of the displacement and nothing else. Walls agree with themselves at any
// displacement along them; weights by the number of neighbours keep them from outvoting the rest.
//
// A displacement is the chord from the first place of the radar to the second, in its axes half-way
// through the turn: the mean velocity in the radar's own axes times the time [m].
class DisplacementVotes {
 public:
  static constexpr double kReach = 12.0;  // largest displacement along either axis [m]

  // No votes at all.
  DisplacementVotes();

  // `max_turn`: turns from -max_turn to max_turn are tried [rad].
  DisplacementVotes(const VotingPoints& before, const VotingPoints& after, double max_turn);

  // Votes for a displacement, at the turn that has most; Mean() beyond the reach.
  double At(const Eigen::Vector2d& displacement) const;

  // The displacement with the most votes [m].
  Eigen::Vector2d Best() const;

  // Over all displacements in reach: what chance gives.
  double Mean() const { return mean_; }

  // These votes times `keep`, and those of `other`, of displacements in as much time.
  void Fade(double keep, const DisplacementVotes& other);

 private:
  void UpdateMean();

  std::vector<double> votes_;  // on a grid of displacements
  double mean_ = 0.0;
};

}  // namespace radive
