// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/motion_fusion.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "radive/util/seconds.h"

namespace radive {
namespace {

// A radar whose next scan is late by this many of its intervals is not waited for.
constexpr std::int64_t kMaxIntervals = 2;
// One that has sent a single scan so far [ns].
constexpr std::int64_t kFirstInterval = 1'000'000'000;

// Times over which the variances of a radar are averaged [s].
constexpr double kReportedTime = 60.0;
constexpr double kComparedTime = 300.0;
// What is reported is worth as much as comparing for this long [s].
constexpr double kReportedWorth = 20.0;

// Time over which rotations are compared [s]: longer than the noise of scans lasts, which a submap
// takes back, and short enough for many comparisons.
constexpr double kDeviationTime = 3.0;
// Least redundancy, 1 - share of the weight, by which a deviation is scaled up.
constexpr double kMinRedundancy = 0.05;

// Least standard deviations of a step [rad, m]: no odometry is as sure of itself as one that
// stands.
constexpr double kMinRotationSigma = 1e-4;
constexpr double kMinTranslationSigma = 1e-3;

}  // namespace

bool MotionFusion::Covers(const Step& step, std::int64_t begin_ns, std::int64_t end_ns) {
  return step.begin_ns <= begin_ns && step.end_ns >= end_ns;
}

bool MotionFusion::IsActive(const Chain& chain, std::int64_t stamp_ns) {
  const std::int64_t longest =
      chain.usual_interval_ns > 0 ? kMaxIntervals * chain.usual_interval_ns : kFirstInterval;
  return stamp_ns - chain.stamp_ns <= longest;
}

MotionFusion::MeanRate MotionFusion::Mean(const std::vector<const Step*>& steps) {
  Twist sum = Twist::Zero(), weighted = Twist::Zero();
  for (const Step* step : steps) {
    sum += step->weight;
    weighted += step->weight.cwiseProduct(step->rate);
  }
  MeanRate mean = {Twist::Zero(), Matrix6d::Zero()};
  if (steps.empty()) return mean;
  mean.rate = weighted.cwiseQuotient(sum);
  for (const Step* step : steps) {
    const Twist share = step->weight.cwiseQuotient(sum);
    mean.covariance += share.asDiagonal() * step->covariance * share.asDiagonal();
  }
  return mean;
}

MotionFusion::MeanRate MotionFusion::LastRate(std::int64_t stamp_ns) const {
  std::vector<const Step*> last;
  for (const auto& [radar, chain] : chains_) {
    if (!chain.steps.empty() && IsActive(chain, stamp_ns)) last.push_back(&chain.steps.back());
  }
  MeanRate mean = Mean(last);
  if (last.empty()) mean.rate.tail<3>() = velocity_;
  return mean;
}

MotionFusion::MeanRate MotionFusion::RateWithin(std::int64_t begin_ns, std::int64_t end_ns) const {
  std::vector<const Step*> covering;
  for (const auto& [radar, chain] : chains_) {
    for (const Step& step : chain.steps) {
      if (Covers(step, begin_ns, end_ns)) covering.push_back(&step);
    }
  }
  return covering.empty() ? LastRate(end_ns) : Mean(covering);
}

std::set<std::int64_t> MotionFusion::Breaks(std::int64_t begin_ns, std::int64_t end_ns) const {
  if (begin_ns >= end_ns) return {};
  std::set<std::int64_t> breaks = {end_ns};
  for (const auto& [radar, chain] : chains_) {
    for (const Step& step : chain.steps) {
      for (const std::int64_t stamp : {step.begin_ns, step.end_ns}) {
        if (stamp > begin_ns && stamp < end_ns) breaks.insert(stamp);
      }
    }
  }
  return breaks;
}

// How far each radar turns away from the mean. The deviation forgets with time constant T and so
// has T / 2 times the variance of one second; of that the mean itself takes the radar's share.
void MotionFusion::Compare(std::int64_t begin_ns, std::int64_t end_ns) {
  std::vector<std::pair<Chain*, const Step*>> covering;
  double sum = 0.0;
  for (auto& [radar, chain] : chains_) {
    for (const Step& step : chain.steps) {
      if (!Covers(step, begin_ns, end_ns)) continue;
      covering.emplace_back(&chain, &step);
      sum += step.weight[0];
    }
  }
  if (covering.size() < 2) return;
  const double dt = Seconds(end_ns - begin_ns);
  const Eigen::Vector3d mean_rate = RateWithin(begin_ns, end_ns).rate.head<3>();
  for (const auto& [chain, step] : covering) {
    chain->deviation =
        std::exp(-dt / kDeviationTime) * chain->deviation + dt * (step->rate.head<3>() - mean_rate);
    const double redundancy = std::max(kMinRedundancy, 1.0 - step->weight[0] / sum);
    const double variance = chain->deviation.squaredNorm() / (0.5 * kDeviationTime * redundancy);
    chain->compared_time = std::min(chain->compared_time + dt, kComparedTime);
    chain->deviation_variance += dt / chain->compared_time * (variance - chain->deviation_variance);
  }
}

void MotionFusion::SettleUntil(std::int64_t stamp_ns) {
  for (const std::int64_t end : Breaks(settled_ns_, stamp_ns)) {
    const Twist twist = RateWithin(settled_ns_, end).rate * Seconds(end - settled_ns_);
    T_world_settled_ = T_world_settled_ * MotionAlong(twist);
    Compare(settled_ns_, end);
    settled_ns_ = end;
  }
  for (auto& [radar, chain] : chains_) {
    while (chain.steps.size() > 1 && chain.steps.front().end_ns <= settled_ns_) {
      chain.steps.pop_front();
    }
  }
}

double MotionFusion::Chain::RotationVariance() const {
  return (kReportedWorth * rotation_variance + compared_time * deviation_variance) /
         (kReportedWorth + compared_time);
}

// A step by which `chain` comes to `T_own_body`. It weighs what its radar is usually worth: how
// sure a scan is of itself changes with what it has locked on to, be that wrong. Only what is worse
// than usual, as a pose that was only predicted, counts less.
void MotionFusion::AddStep(std::int64_t stamp_ns,
                           const Rigid3& T_own_body,
                           const Matrix6d& covariance,
                           Chain* chain) {
  const double dt = Seconds(stamp_ns - chain->stamp_ns);
  Step step;
  step.begin_ns = chain->stamp_ns;
  step.end_ns = stamp_ns;
  step.rate = TwistOf(chain->T_own_body.Inverse() * T_own_body) / dt;
  step.covariance = TurnedCovariance(T_own_body.RotationMatrix().transpose(), covariance) / dt;

  const double min_rotation = kMinRotationSigma * kMinRotationSigma / dt;
  const double min_translation = kMinTranslationSigma * kMinTranslationSigma / dt;
  const double rotation = step.covariance.topLeftCorner<3, 3>().trace() + min_rotation;
  const double translation = step.covariance.bottomRightCorner<3, 3>().trace() + min_translation;
  chain->reported_time = std::min(chain->reported_time + dt, kReportedTime);
  const double gain = dt / chain->reported_time;
  chain->rotation_variance += gain * (rotation - chain->rotation_variance);
  chain->translation_variance += gain * (translation - chain->translation_variance);
  const double rotation_excess = std::max(1.0, rotation / chain->rotation_variance);
  const double translation_excess = std::max(1.0, translation / chain->translation_variance);
  step.weight << Eigen::Vector3d::Constant(1.0 / (rotation_excess * chain->RotationVariance())),
      Eigen::Vector3d::Constant(1.0 / (translation_excess * chain->translation_variance));
  chain->steps.push_back(step);
}

void MotionFusion::Add(int radar,
                       std::int64_t stamp_ns,
                       const Rigid3& T_own_body,
                       const Matrix6d& covariance,
                       const Eigen::Vector3d& velocity) {
  if (chains_.empty()) settled_ns_ = stamp_ns;
  const auto [entry, is_new] = chains_.try_emplace(radar);
  Chain& chain = entry->second;
  std::int64_t interval = 0;
  if (!is_new) {
    CHECK_GT(stamp_ns, chain.stamp_ns);
    AddStep(stamp_ns, T_own_body, covariance, &chain);
    interval = stamp_ns - chain.stamp_ns;
    // Follows slower radars in time, and one missing scan not at all.
    chain.usual_interval_ns =
        chain.usual_interval_ns == 0
            ? interval
            : std::min(chain.usual_interval_ns + chain.usual_interval_ns / 10, interval);
  }
  chain.stamp_ns = stamp_ns;
  chain.T_own_body = T_own_body;
  MoveTo(stamp_ns, Seconds(interval), velocity);
}

void MotionFusion::AddPredicted(int radar,
                                std::int64_t stamp_ns,
                                const Rigid3& T_own_body,
                                const Matrix6d& covariance,
                                const Eigen::Vector3d& velocity) {
  const auto known = chains_.find(radar);
  if (known == chains_.end() || known->second.steps.empty() || !IsActive(known->second, stamp_ns)) {
    Add(radar, stamp_ns, T_own_body, covariance, velocity);
    return;
  }
  MoveTo(stamp_ns, Seconds(stamp_ns - known->second.stamp_ns), velocity);
}

void MotionFusion::MoveTo(std::int64_t stamp_ns, double interval, const Eigen::Vector3d& velocity) {
  std::int64_t horizon = stamp_ns;
  for (const auto& [number, other] : chains_) {
    if (IsActive(other, stamp_ns)) horizon = std::min(horizon, other.stamp_ns);
  }
  SettleUntil(horizon);
  T_world_body_ = T_world_settled_;
  std::int64_t begin_ns = settled_ns_;
  for (const std::int64_t end_ns : Breaks(begin_ns, stamp_ns)) {
    const Twist twist = RateWithin(begin_ns, end_ns).rate * Seconds(end_ns - begin_ns);
    T_world_body_ = T_world_body_ * MotionAlong(twist);
    begin_ns = end_ns;
  }
  covariance_ =
      interval * TurnedCovariance(T_world_body_.RotationMatrix(), LastRate(stamp_ns).covariance);
  velocity_ = velocity;
}

}  // namespace radive
