// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/doppler_evidence.h"

#include <algorithm>
#include <cmath>

#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr double kMemory = 100.0;  // values that a mean is taken over

// Pairs about this much apart in time [-] are summed to find the motion of the points, each time
// with this share of the sum so far.
constexpr double kSameTime = 0.2;
constexpr double kKeep = 0.75;

constexpr double kMinDisplacement = 0.4;  // that tells the signs apart [m]
// Farther apart, points and Doppler say different things [m, and share of the displacement].
constexpr double kApart = 0.6;
constexpr double kApartShare = 0.15;

// What decides: standard deviations, and mean advantage of a pair.
constexpr double kMinT = 4.5;
constexpr double kFirmMinT = 6.0;
constexpr double kMinMean = 0.3;
constexpr double kMinMeanAgainst = 0.45;
constexpr double kMinPairs = 4.0;
constexpr double kMinPairsAgainst = 6.0;
constexpr double kMinPairsAtEnd = 3.0;
constexpr double kMinPairsScale = 12.0;

// Of the sum of the last pairs, where the points move: the advantage over standing.
constexpr int kMinRecent = 3;
constexpr double kMovingAdvantage = 1.0;

// A scan tells whether its Doppler has a pattern where it has so many returns, and where no such
// share of them agrees by chance.
constexpr int kMinReturns = 15;
constexpr double kMinShareWithDoppler = 0.1;
constexpr double kMaxChance = 0.8;
constexpr double kPatternShare = 0.6;
constexpr double kPatternAdvantage = 0.5;
// Where a larger share agrees, as at walking pace by chance too.
constexpr double kSlowPatternAdvantage = 0.15;
constexpr double kMinScansSlow = 25.0;
constexpr double kMinScansForSign = 8.0;
constexpr double kMinScans = 15.0;
constexpr double kMinScansAtEnd = 5.0;

constexpr double kOtherScales[] = {0.5, 0.667, 0.8, 1.25, 1.5, 2.0};
constexpr double kSmallestScale = 0.02;
constexpr double kScaleStep = 0.04;  // of the logarithm

// Advantage of a displacement over another, about in standard deviations.
double Advantage(double votes, double other_votes) {
  return (votes - other_votes) / std::sqrt(votes + other_votes + 1.0);
}

bool AreApart(const Eigen::Vector2d& by_points, const Eigen::Vector2d& by_doppler) {
  return (by_points - by_doppler).norm() > std::max(kApart, kApartShare * by_doppler.norm());
}

// The unit that `scale` stands for, as a question.
std::string UnitOf(double scale) {
  struct Unit {
    double scale;
    const char* text;
  };
  for (const Unit& unit : {Unit{3.6, ": km/h?"},
                           Unit{2.237, ": mph?"},
                           Unit{100.0, ": cm/s?"},
                           Unit{10.0, ": tenths of a m/s?"},
                           Unit{0.1, ": tens of m/s?"}}) {
    if (std::abs(std::abs(scale) / unit.scale - 1.0) < 0.08) return unit.text;
  }
  return "";
}

}  // namespace

void MeanTest::Add(double value) {
  if (count_ >= kMemory) {
    const double keep = (kMemory - 1.0) / kMemory;
    count_ *= keep;
    sum_ *= keep;
    sum_squares_ *= keep;
  }
  count_ += 1.0;
  sum_ += value;
  sum_squares_ += value * value;
}

double MeanTest::t() const {
  if (count_ < 1.0) return 0.0;
  constexpr double kPrior = 4.0;  // values of variance 1 that are added
  const double variance =
      (std::max(0.0, sum_squares_ - count_ * mean() * mean()) + kPrior) / (count_ - 1.0 + kPrior);
  return mean() * std::sqrt(count_ / variance);
}

double DopplerEvidence::Scale(int index) {
  const double size = kSmallestScale * std::exp(kScaleStep * (index / 2));
  return index % 2 == 0 ? size : -size;
}

void DopplerEvidence::AddFit(const DopplerFit& fit) {
  ++num_scans_;
  if (fit.share_with_doppler < kMinShareWithDoppler) ++num_without_numbers_;
  last_has_pattern_ = true;
  if (fit.num_returns < kMinReturns) return;
  ++num_fits_tried_;
  if (!fit.v_plus && !fit.v_minus) ++num_without_fit_;
  if (fit.num_by_chance > kMaxChance * fit.num_returns) return;
  const double share = static_cast<double>(fit.num_inliers) / fit.num_returns;
  const double advantage = Advantage(fit.num_inliers, fit.num_by_chance);
  share_.Add(share);
  pattern_.Add(advantage);
  last_has_pattern_ =
      advantage >= (share < kPatternShare ? kPatternAdvantage : kSlowPatternAdvantage);
}

void DopplerEvidence::AddPair(const DisplacementVotes& votes,
                              double dt,
                              const DopplerDisplacement& doppler) {
  const double standing = votes.At(Eigen::Vector2d::Zero());
  const Eigen::Vector2d by_points =
      v_points_ ? Eigen::Vector2d(*v_points_ * dt) : Eigen::Vector2d(0.0, 0.0);
  const double of_points = votes.At(by_points);
  if (v_points_) points_move_test_.Add(Advantage(of_points, standing));
  last_ = LastPair();
  last_.best = votes.Best();
  if (doppler.plus || doppler.minus) {
    const Eigen::Vector2d plus = doppler.plus ? *doppler.plus : Eigen::Vector2d(-*doppler.minus);
    const Eigen::Vector2d minus = doppler.minus ? *doppler.minus : Eigen::Vector2d(-plus);
    const double of_plus = votes.At(plus), of_minus = votes.At(minus);
    const double best = std::max(of_plus, of_minus);
    last_.plus = plus;
    last_.minus = minus;
    last_.of_plus = of_plus;
    last_.of_minus = of_minus;
    if ((plus - minus).norm() > 2.0 * kMinDisplacement) sign_.Add(Advantage(of_plus, of_minus));
    if (v_points_) {
      const bool differs = AreApart(by_points, plus) && AreApart(by_points, minus);
      agreeing_.Add(differs ? 0.0 : 1.0);
      if (differs) {
        points_.Add(Advantage(of_points, best));
        last_.of_points = of_points;
      }
      doppler_way_ += plus.norm();
      points_way_ += by_points.norm();
      way_time_ += dt;
      votes_of_points_ += of_points;
      for (int i = 0; i < kNumScales; ++i) {
        votes_by_scale_[static_cast<std::size_t>(i)] += votes.At(plus / Scale(i));
      }
    }
    if (plus.norm() > kMinDisplacement) {
      for (std::size_t i = 0; i < other_scales_.size(); ++i) {
        const double of_scale =
            std::max(votes.At(plus / kOtherScales[i]), votes.At(minus / kOtherScales[i]));
        other_scales_[i].Add(Advantage(of_scale, best));
      }
    }
  }
  FollowPoints(votes, dt);
}

bool DopplerEvidence::LastPairConfirms(int sign) const {
  if (!last_.plus) return false;
  const Eigen::Vector2d& by_doppler = sign > 0 ? *last_.plus : last_.minus;
  const Eigen::Vector2d& opposite = sign > 0 ? last_.minus : *last_.plus;
  if (by_doppler.norm() < kMinDisplacement) return last_.best.norm() < kMinDisplacement;
  return !AreApart(last_.best, by_doppler) && AreApart(last_.best, opposite);
}

double DopplerEvidence::LastAdvantage(int sign) const {
  if (!last_.plus) return 0.0;
  const double of_sign = sign > 0 ? last_.of_plus : last_.of_minus;
  const double of_opposite = sign > 0 ? last_.of_minus : last_.of_plus;
  const bool is_told_apart = (*last_.plus - last_.minus).norm() > 2.0 * kMinDisplacement;
  const double over_opposite = is_told_apart ? Advantage(of_sign, of_opposite) : 0.0;
  return last_.of_points ? std::min(over_opposite, Advantage(of_sign, *last_.of_points))
                         : over_opposite;
}

void DopplerEvidence::BeginStretch() {
  recent_dt_ = 0.0;
  v_points_.reset();
}

void DopplerEvidence::FollowPoints(const DisplacementVotes& votes, double dt) {
  const bool is_same_time = recent_dt_ > 0.0 && std::abs(dt - recent_dt_) < kSameTime * recent_dt_;
  if (!is_same_time) {
    recent_ = DisplacementVotes();
    num_recent_ = 0;
  }
  recent_.Fade(kKeep, votes);
  recent_dt_ = is_same_time ? kKeep * recent_dt_ + (1.0 - kKeep) * dt : dt;
  ++num_recent_;
  v_points_ = recent_.Best() / recent_dt_;
}

bool DopplerEvidence::PointsStand() const {
  if (num_recent_ < kMinRecent) return false;
  const Eigen::Vector2d best = recent_.Best();
  return best.norm() < kMinDisplacement ||
         Advantage(recent_.At(best), recent_.At(Eigen::Vector2d::Zero())) < kMovingAdvantage;
}

std::optional<Eigen::Vector2d> DopplerEvidence::MotionOfPoints() const {
  if (num_recent_ < kMinRecent || PointsStand()) return std::nullopt;
  return v_points_;
}

bool DopplerEvidence::HasNoPattern(double min_scans) const {
  if (share_.mean() < kPatternShare) {
    return pattern_.count() >= min_scans && pattern_.mean() < kPatternAdvantage;
  }
  return pattern_.count() >= std::max(min_scans, kMinScansSlow) &&
         pattern_.mean() < kSlowPatternAdvantage;
}

bool DopplerEvidence::Disagrees(double min_t, double min_pairs) const {
  if (points_.count() >= min_pairs && points_.t() > min_t && points_.mean() > kMinMeanAgainst &&
      agreeing_.mean() < 0.5) {
    return true;
  }
  return std::any_of(other_scales_.begin(), other_scales_.end(), [min_t](const MeanTest& test) {
    return test.count() >= kMinPairsScale && test.t() > min_t && test.mean() > kMinMeanAgainst;
  });
}

std::string DopplerEvidence::DisagreementText() const {
  const double doppler_speed = doppler_way_ / way_time_, points_speed = points_way_ / way_time_;
  if (doppler_speed < 0.1 * points_speed && doppler_speed < 0.5) {
    return FormatText(
        "Doppler says %.2f m/s where the points move at %.1f m/s: zero, or compensated "
        "for the motion of the radar?",
        doppler_speed,
        points_speed);
  }
  const auto most = std::max_element(votes_by_scale_.begin(), votes_by_scale_.end());
  const auto index = static_cast<std::size_t>(std::distance(votes_by_scale_.begin(), most));
  // The middle of the top, among the scales of that sign.
  double sum = 0.0, weighted = 0.0;
  for (std::size_t i = index % 2; i < votes_by_scale_.size(); i += 2) {
    const double weight = std::max(0.0, votes_by_scale_[i] - 0.95 * *most);
    sum += weight;
    weighted += weight * std::log(std::abs(Scale(static_cast<int>(i))));
  }
  const double scale =
      sum > 0.0 ? std::copysign(std::exp(weighted / sum), Scale(static_cast<int>(index))) : 0.0;
  if (*most > 0.8 * votes_of_points_ && std::abs(scale) > 1.5 * kSmallestScale &&
      points_speed > 0.3) {
    const std::string number =
        std::abs(scale) < 9.95 ? FormatText("%.2g", scale) : FormatText("%.0f", scale);
    return "Doppler speed is " + number + " times the motion of the points" + UnitOf(scale);
  }
  return FormatText(
      "Doppler does not follow the motion of the points: %.1f m/s by the Doppler, %.1f "
      "m/s by the points",
      doppler_speed,
      points_speed);
}

DopplerFinding DopplerEvidence::Judge(bool is_end, bool is_firm) const {
  DopplerFinding finding;
  const double min_scans = is_end ? kMinScansAtEnd : kMinScans;
  const double min_t = is_firm ? kFirmMinT : kMinT;
  if (num_without_numbers_ >= (is_end ? 1.0 : 10.0) && num_without_numbers_ >= 0.9 * num_scans_) {
    finding.kind = DopplerFinding::Kind::kNoNumbers;
    finding.evidence =
        FormatText("Doppler is no number in %d of %d scans", num_without_numbers_, num_scans_);
  } else if (HasNoPattern(min_scans)) {
    finding.kind = DopplerFinding::Kind::kNoPattern;
    finding.evidence = FormatText(
        "Doppler makes no sense: only %.0f %% of the returns of a scan agree on a velocity, as "
        "many "
        "as by chance",
        100.0 * share_.mean());
  } else if (num_fits_tried_ >= min_scans && num_without_fit_ >= 0.8 * num_fits_tried_ &&
             points_move_test_.t() > min_t) {
    finding.kind = DopplerFinding::Kind::kNoPattern;
    finding.evidence = FormatText(
        "Doppler makes no sense: the returns do not agree on a velocity in %d of %d scans",
        num_without_fit_,
        num_fits_tried_);
  } else if (Disagrees(min_t, is_end ? kMinPairsAtEnd : kMinPairsAgainst)) {
    finding.kind = DopplerFinding::Kind::kDisagrees;
    finding.evidence = DisagreementText();
  } else if (sign_.count() >= kMinPairs && std::abs(sign_.t()) > min_t &&
             std::abs(sign_.mean()) > kMinMean && points_.t() < 2.0 &&
             (pattern_.count() < kMinScansForSign || pattern_.mean() > kSlowPatternAdvantage)) {
    finding.kind = sign_.mean() > 0.0 ? DopplerFinding::Kind::kPlus : DopplerFinding::Kind::kMinus;
    finding.evidence = FormatText(
        "by the motion of the points in %.0f pairs of scans, %.1f standard "
        "deviations from the opposite",
        sign_.count(),
        std::abs(sign_.t()));
  }
  return finding;
}

}  // namespace radive
