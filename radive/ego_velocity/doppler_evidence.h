// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "radive/ego_velocity/displacement_votes.h"
#include "radive/ego_velocity/doppler_fit.h"

namespace radive {

// Mean of a quantity, and how sure it is not zero. Forgets slowly, so that what changes in a drive
// shows.
class MeanTest {
 public:
  void Add(double value);
  double count() const { return count_; }
  double mean() const { return count_ > 0.0 ? sum_ / count_ : 0.0; }
  // The mean in its own standard deviations; the variance of the values is at least about 1 as long
  // as there are few of them.
  double t() const;

 private:
  double count_ = 0.0;
  double sum_ = 0.0;
  double sum_squares_ = 0.0;
};

// Displacement of the radar between two scans by the Doppler [m], see DisplacementVotes.
struct DopplerDisplacement {
  std::optional<Eigen::Vector2d> plus;   // with the Doppler as stored
  std::optional<Eigen::Vector2d> minus;  // with the Doppler turned
};

struct DopplerFinding {
  enum class Kind {
    kOpen,       // the points do not tell, or not yet
    kPlus,       // the Doppler is that of the points' motion
    kMinus,      // and with its sign turned
    kDisagrees,  // the points move otherwise
    kNoPattern,  // the Doppler does not depend on the direction of the returns as that of one
                 // motion
    kNoNumbers   // (nearly) no return has a Doppler
  };
  Kind kind = Kind::kOpen;
  std::string evidence;  // "Doppler speed is 3.6 times the motion of the points: km/h?"
};

// Whether the Doppler of a radar is that of its motion: compares, pair of scans by pair of scans,
// the votes of the points for the displacement by the Doppler, for its opposite, and for the one
// that goes on as the points have moved in the pairs before, which knows nothing of the Doppler and
// is tested on votes that it was not found by.
class DopplerEvidence {
 public:
  // `fit`: of a scan with returns.
  void AddFit(const DopplerFit& fit);
  // The last pair confirms the Doppler of that sign by itself: the points moved as it says, or
  // neither moved.
  bool LastPairConfirms(int sign) const;
  // Its advantage for the Doppler of that sign over the opposite, and over the motion that the
  // points had in the pairs before [standard deviations].
  double LastAdvantage(int sign) const;
  // The returns of the last scan agree on a velocity better than by chance, or are too few to tell.
  bool LastScanHasPattern() const { return last_has_pattern_; }
  // Pairs by which factors other than 1 were looked for.
  double NumScalePairs() const { return other_scales_.front().count(); }

  // The next pair is of scans some time after the last: what the points did before is over.
  void BeginStretch();
  // `dt`: between the scans [s].
  void AddPair(const DisplacementVotes& votes, double dt, const DopplerDisplacement& doppler);

  // `is_end`: nothing will follow, so that few scans have to do for the plainest faults. `is_firm`:
  // asks for more, where a finding would overturn an earlier one.
  DopplerFinding Judge(bool is_end, bool is_firm) const;

  // The last pairs say that the points stand, whatever the Doppler says.
  bool PointsStand() const;
  // Velocity of the radar in the plane by the last pairs, whatever the Doppler says [m/s]; none
  // where they do not tell, or stand.
  std::optional<Eigen::Vector2d> MotionOfPoints() const;
  // Positive: for the Doppler as stored; in standard deviations.
  double SignEvidence() const { return sign_.t(); }

 private:
  static constexpr int kNumScales = 480;
  // Doppler speed by speed of the points, both signs in turn.
  static double Scale(int index);

  void FollowPoints(const DisplacementVotes& votes, double dt);
  bool HasNoPattern(double min_scans) const;
  bool Disagrees(double min_t, double min_pairs) const;
  std::string DisagreementText() const;

  int num_scans_ = 0;
  int num_without_numbers_ = 0;
  int num_fits_tried_ = 0;
  int num_without_fit_ = 0;
  MeanTest share_;    // of the returns that agree on a velocity
  MeanTest pattern_;  // how many more than by chance

  MeanTest sign_;              // the Doppler as stored against its opposite
  MeanTest points_;            // the motion of the points against the better of the two
  MeanTest points_move_test_;  // against standing
  MeanTest agreeing_;          // 1 for pairs in which points and Doppler say about the same
  std::array<MeanTest, 6> other_scales_;  // against the better of the two signs
  std::array<double, kNumScales> votes_by_scale_{};
  double votes_of_points_ = 0.0;  // in the pairs that votes_by_scale_ has
  double doppler_way_ = 0.0, points_way_ = 0.0, way_time_ = 0.0;  // [m, m, s]

  struct LastPair {
    std::optional<Eigen::Vector2d> plus;  // displacement by the Doppler as stored
    Eigen::Vector2d minus = Eigen::Vector2d::Zero();
    Eigen::Vector2d best = Eigen::Vector2d::Zero();  // that with the most votes
    double of_plus = 0.0, of_minus = 0.0;
    std::optional<double> of_points;  // where they moved otherwise in the pairs before
  };
  LastPair last_;
  bool last_has_pattern_ = true;

  DisplacementVotes recent_;  // of the last pairs, all about the same time apart
  double recent_dt_ = 0.0;    // [s]; 0: none
  int num_recent_ = 0;
  std::optional<Eigen::Vector2d> v_points_;  // [m/s]
};

}  // namespace radive
