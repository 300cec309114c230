// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/doppler_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/ego_velocity/spread_points.h"
#include "radive/preprocessing/preprocess.h"

namespace radive {
namespace {

constexpr std::size_t kMostPoints = 300;
constexpr std::size_t kMostCandidates = 4 * kMostPoints;  // that they are chosen from

// Time between the scans of a pair, of a radar that is slow by its Doppler and of any other [s];
// longer ones than the last are none.
constexpr double kSlowTime = 0.5;
constexpr double kUsualTime = 0.2;
constexpr double kLongestTime = 1.0;
constexpr double kSlowSpeed = 2.0;  // [m/s]
constexpr double kPairInterval = 0.2;
constexpr double kPairIntervalOpen = 0.06;  // as long as nothing is decided
constexpr double kStampJitter = 0.02;

constexpr double kMaxTurnRate = 0.5;  // between the scans of a pair [rad/s]

// All scans are looked at for this long, then the first few of each while [s].
constexpr double kFirstLook = 30.0;
constexpr double kLook = 1.5;
constexpr double kLookIntervalOpen = 8.0;
constexpr double kLookInterval = 15.0;
constexpr double kFirstLookInterval = 2.0;  // grows twofold from look to look

// Where a radar is sure by its own points, the first look ends when it has had so many pairs to see
// whether the Doppler has a wrong unit, and each later one at the first pair that confirms it.
// Where none does, and on the average they speak against it by so much, the look goes on so long.
constexpr double kPairsOfFirstLook = 15.0;
constexpr double kDoubt = -1.0;     // [standard deviations]
constexpr double kLongLook = 10.0;  // [s]
// By so much, or in so many pairs whose scans make no sense, it contradicts what was decided: then
// what follows is judged by itself.
constexpr double kContradiction = -4.5;  // [standard deviations]
constexpr double kScansWithoutPattern = 8.0;
constexpr double kShareWithPattern = 0.3;
constexpr double kShareOfSense = 0.5;  // with less, no single scan ends the look

// A drive that stands longer than this is remarkable [s].
constexpr double kLongStanding = 10.0;

// Velocities of the points that are kept for the scans that wait, and how far they hold [s].
constexpr std::size_t kMostVelocities = 500;
constexpr double kVelocityHolds = 3.0;

// Evidence on the sign that outweighs the custom of driving forward [standard deviations].
constexpr double kLikelyT = 1.5;

double Seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

// The speed that the Doppler says; none when the returns agree on none.
std::optional<double> Speed(const DopplerFit& fit) {
  if (!fit.v_plus) return std::nullopt;
  return fit.v_plus->norm();
}

bool SaysStanding(const DopplerFit& fit) { return Speed(fit).value_or(1e9) < kStandingSpeed; }

std::vector<Eigen::Vector2d> InPlane(const std::vector<RadarReturn>& returns,
                                     const SensorOptions& sensor) {
  const Eigen::Matrix<double, 2, 3> R = sensor.T_vehicle_radar().RotationMatrix().topRows<2>();
  std::vector<Eigen::Vector2d> plane;
  plane.reserve(returns.size());
  for (const RadarReturn& ret : returns) plane.emplace_back(R * ret.position);
  return plane;
}

// Of a dense scan only as many returns as leave enough in the field of view are looked at.
VotingPoints PointsOf(const RadarScan& scan,
                      const SensorOptions& sensor,
                      const PreprocessingOptions& preprocessing) {
  RadarScan points;
  points.has_doppler = false;  // returns without a number for it count too
  points.is_planar = scan.is_planar;
  if (scan.returns.size() <= kMostCandidates) {
    points.returns = scan.returns;
  } else {
    for (const std::size_t index : SpreadOut(InPlane(scan.returns, sensor), kMostCandidates)) {
      points.returns.push_back(scan.returns[index]);
    }
  }
  return MakeVotingPoints(InPlane(CorrectAndGate(points, sensor, preprocessing, nullptr), sensor),
                          kMostPoints);
}

}  // namespace

DopplerCheck::Verdict DopplerCheck::VerdictOf(int number) const {
  const auto entry = radars_.find(number);
  const bool is_own = entry != radars_.end() && IsFirm(entry->second);
  if (!is_own && first_decided_) return radars_.at(*first_decided_).verdict;
  return entry == radars_.end() ? Verdict::kOpen : entry->second.verdict;
}

bool DopplerCheck::IsDecided(int radar) const { return VerdictOf(radar) != Verdict::kOpen; }

int DopplerCheck::Factor(int radar) const {
  const Verdict verdict = VerdictOf(radar);
  return verdict == Verdict::kOff ? 0 : verdict == Verdict::kMinus ? -1 : 1;
}

bool DopplerCheck::IsStanding(const RadarScan& scan) const {
  const auto entry = radars_.find(scan.radar);
  return entry != radars_.end() && scan.stamp_ns <= entry->second.standing_until_ns;
}

std::string DopplerCheck::NameOf(int radar) const {
  return radars_.size() > 1 ? "radar " + std::to_string(radar) + ": " : "";
}

bool DopplerCheck::IsFirm(const Radar& radar) {
  return radar.verdict != Verdict::kOpen && !radar.is_assumed;
}

bool DopplerCheck::IsLookingAt(std::int64_t stamp_ns, int number, const Radar& radar) const {
  if (radar.verdict == Verdict::kOff) return false;
  if (IsFirm(radar)) return stamp_ns >= radar.next_look_ns.value_or(INT64_MIN);
  const double time = std::max(0.0, Seconds(stamp_ns - radar.begin_ns));
  const bool is_sure = IsDecided(number) && !radar.is_assumed;
  if (!is_sure && time < kFirstLook) return true;
  return std::fmod(time, is_sure ? kLookInterval : kLookIntervalOpen) < kLook;
}

void DopplerCheck::Add(const RadarScan& scan) {
  if (!scan.has_doppler || scan.returns.empty()) return;
  const auto [entry, is_new] = radars_.try_emplace(scan.radar);
  Radar& radar = entry->second;
  if (is_new) radar.begin_ns = scan.stamp_ns;
  radar.last_ns = scan.stamp_ns;
  std::deque<PastScan>& past = radar.past;
  if (!past.empty() && scan.stamp_ns <= past.back().stamp_ns) past.clear();
  const SensorOptions sensor = sensor_.ForRadar(scan.radar);
  const bool is_open = !IsDecided(scan.radar);
  bool is_looking = IsLookingAt(scan.stamp_ns, scan.radar, radar);
  if (!is_looking && !is_open) {
    past.clear();
    return;
  }
  // Where nothing is open, only the scans of pairs.
  if (IsFirm(radar) && !past.empty() &&
      Seconds(scan.stamp_ns - past.back().stamp_ns) < kUsualTime - kStampJitter) {
    return;
  }
  if (past.empty()) radar.look_begin_ns = scan.stamp_ns;
  const DopplerFit fit = FitDoppler(scan, sensor);
  if (!is_looking && SaysStanding(fit)) {
    past.clear();
    if (radar.standing_until_ns != INT64_MIN) radar.standing_until_ns = scan.stamp_ns;
    return;
  }
  radar.evidence.AddFit(fit);
  if (fit.v_plus && !SaysStanding(fit)) {
    ++radar.num_moving;
    radar.forward += (sensor.T_vehicle_radar().rotation * *fit.v_plus).x();
  }
  past.push_back({scan.stamp_ns, PointsOf(scan, sensor, preprocessing_), fit});
  while (Seconds(scan.stamp_ns - past.front().stamp_ns) > kLongestTime) past.pop_front();

  const double speed = Speed(fit).value_or(0.0);
  const bool is_slow = speed > kStandingSpeed && speed < kSlowSpeed;
  const double wanted = (is_slow ? kSlowTime : kUsualTime) - kStampJitter;
  const auto after = std::prev(past.end());
  auto before = after;
  while (before != past.begin() && Seconds(scan.stamp_ns - before->stamp_ns) < wanted) --before;
  const bool is_due = !radar.last_pair_ns ||
                      Seconds(scan.stamp_ns - *radar.last_pair_ns) > kPairInterval - kStampJitter;
  if (is_due && Seconds(scan.stamp_ns - before->stamp_ns) >= wanted) {
    AddPair(*before, *after, scan.radar, &radar);
  }
  Judge(scan.radar, /*is_end=*/false, &radar);
  if (IsFirm(radar)) EndLookIfDone(scan.stamp_ns, &radar);
}

void DopplerCheck::LookAgain(int number) {
  const auto entry = radars_.find(number);
  if (entry == radars_.end() || !entry->second.next_look_ns) return;
  std::int64_t& next_look_ns = *entry->second.next_look_ns;
  next_look_ns = std::min(next_look_ns, entry->second.last_ns);
}

bool DopplerCheck::IsContradicted(std::int64_t stamp_ns, const Radar& radar) {
  if (!radar.next_look_ns || radar.is_doubted) return false;
  if (Seconds(stamp_ns - radar.look_begin_ns) < kLook) return false;
  return radar.look_advantage.t() < kContradiction ||
         (radar.look_pattern.count() >= kScansWithoutPattern &&
          radar.look_pattern.mean() < kShareWithPattern);
}

void DopplerCheck::EndLookIfDone(std::int64_t stamp_ns, Radar* radar) {
  const double time = Seconds(stamp_ns - radar->look_begin_ns);
  const int sign = radar->verdict == Verdict::kMinus ? -1 : 1;
  bool is_done = time > kLongLook;
  if (!radar->next_look_ns) {
    is_done = radar->evidence.NumScalePairs() >= kPairsOfFirstLook || time > kFirstLook;
  } else if (radar->last_pair_ns == stamp_ns) {
    radar->look_advantage.Add(radar->evidence.LastAdvantage(sign));
    radar->look_pattern.Add(radar->evidence.LastScanHasPattern() ? 1.0 : 0.0);
    is_done |= radar->evidence.LastScanHasPattern() &&
               (radar->evidence.LastPairConfirms(sign) ||
                (time > kLook && radar->look_advantage.t() > kDoubt &&
                 radar->look_pattern.mean() > kShareOfSense));
  } else {
    is_done |= time > kLook && radar->look_advantage.count() == 0.0;
  }
  // What was seen long ago must not outvote what is seen now.
  if (IsContradicted(stamp_ns, *radar)) {
    radar->evidence = DopplerEvidence();
    radar->is_doubted = true;
    radar->look_begin_ns = stamp_ns;
    return;
  }
  if (!is_done) return;
  radar->is_doubted = false;
  radar->look_interval = std::clamp(2.0 * radar->look_interval, kFirstLookInterval, kLookInterval);
  radar->next_look_ns = stamp_ns + static_cast<std::int64_t>(radar->look_interval * 1e9);
  radar->look_advantage = MeanTest();
  radar->look_pattern = MeanTest();
}

void DopplerCheck::AddPair(const PastScan& before,
                           const PastScan& after,
                           int number,
                           Radar* radar) const {
  const double dt = Seconds(after.stamp_ns - before.stamp_ns);
  if (radar->last_pair_ns && Seconds(after.stamp_ns - *radar->last_pair_ns) > kLongestTime) {
    radar->evidence.BeginStretch();
  }
  radar->last_pair_ns = after.stamp_ns;
  const DisplacementVotes votes(before.points, after.points, kMaxTurnRate * dt);
  const Eigen::Matrix3d R_vehicle_radar =
      sensor_.ForRadar(number).T_vehicle_radar().RotationMatrix();
  const auto displacement = [&](const std::optional<Eigen::Vector3d>& v_before,
                                const std::optional<Eigen::Vector3d>& v_after) {
    std::optional<Eigen::Vector2d> result;
    if (v_before && v_after) {
      result = (R_vehicle_radar * (0.5 * dt * (*v_before + *v_after))).head<2>();
    }
    return result;
  };
  radar->evidence.AddPair(votes,
                          dt,
                          {displacement(before.fit.v_plus, after.fit.v_plus),
                           displacement(before.fit.v_minus, after.fit.v_minus)});
  if (!IsFirm(*radar) || radar->is_doubted) {
    if (const auto v_vehicle = radar->evidence.MotionOfPoints()) {
      radar->motion_of_points.push_back({after.stamp_ns, *v_vehicle});
    }
    if (radar->motion_of_points.size() > kMostVelocities) radar->motion_of_points.pop_front();
  }
  if (SaysStanding(before.fit) && SaysStanding(after.fit) && radar->evidence.PointsStand()) {
    radar->standing_until_ns = after.stamp_ns;
  }
}

void DopplerCheck::Judge(int number, bool is_end, Radar* radar) {
  const DopplerFinding finding = radar->evidence.Judge(is_end, IsFirm(*radar));
  if (finding.kind != DopplerFinding::Kind::kOpen) Decide(number, finding, radar);
}

void DopplerCheck::Decide(int number, const DopplerFinding& finding, Radar* radar) {
  using Kind = DopplerFinding::Kind;
  const bool is_sign = finding.kind == Kind::kPlus || finding.kind == Kind::kMinus;
  Verdict verdict = finding.kind == Kind::kPlus                               ? Verdict::kPlus
                    : finding.kind == Kind::kMinus && sign_ == Sign::kUnknown ? Verdict::kMinus
                                                                              : Verdict::kOff;
  const Verdict earlier = radar->verdict;
  const bool was_assumed = std::exchange(radar->is_assumed, false);
  if (verdict == earlier && !was_assumed) return;
  radar->verdict = verdict;
  radar->look_begin_ns = radar->last_ns;
  if (!first_decided_) {
    first_decided_ = number;
    WarnOfOtherAssumptions(number);
  }
  const bool is_change = earlier != Verdict::kOpen && earlier != verdict;
  const std::string since = is_change ? " from here on, after other evidence before" : "";
  if (verdict == Verdict::kOff) {
    const std::string what =
        is_sign ? "Doppler has the opposite sign of the motion of the points, after "
                  "input.doppler_sign: " +
                      finding.evidence
                : finding.evidence;
    Remark(true, NameOf(number) + what + "; Doppler is switched off" + since);
  } else if (sign_ == Sign::kGiven) {
    Remark(is_change,
           NameOf(number) + "Doppler agrees with the points: " + finding.evidence + since);
  } else {
    Remark(is_change,
           NameOf(number) + "Doppler sign " + (verdict == Verdict::kPlus ? "+1" : "-1") + ": " +
               finding.evidence + since);
  }
}

// They go by this radar from here on.
void DopplerCheck::WarnOfOtherAssumptions(int number) {
  const Verdict verdict = radars_.at(number).verdict;
  for (const auto& [other, radar] : radars_) {
    if (other == number || !radar.is_assumed || radar.verdict == verdict) continue;
    Remark(true,
           NameOf(other) + "Doppler goes by radar " + std::to_string(number) +
               " from here on, after its sign was assumed otherwise before");
  }
}

void DopplerCheck::Assume(int number) {
  if (IsDecided(number)) return;
  Guess(number);
  Remark(false, NameOf(number) + "so far " + radars_.at(number).why_assumed);
}

void DopplerCheck::Guess(int number) {
  Radar& radar = radars_[number];
  radar.is_assumed = true;
  radar.verdict = Verdict::kPlus;
  if (sign_ == Sign::kGiven) {
    radar.why_assumed =
        "the points do not tell whether the Doppler is that of their motion; it is believed";
    return;
  }
  const double t = radar.evidence.SignEvidence();
  const bool points_tell = std::abs(t) > kLikelyT;
  if ((points_tell ? t : radar.forward) < 0.0) radar.verdict = Verdict::kMinus;
  radar.why_assumed = std::string("Doppler sign undecided, ") +
                      (radar.verdict == Verdict::kPlus ? "+1" : "-1") + " assumed: " +
                      (radar.num_moving == 0 ? "the radar does not move"
                       : points_tell         ? "likelier by the motion of the points"
                                             : "the vehicle then drives forward") +
                      "; set input.doppler_sign to be sure";
}

void DopplerCheck::Finish() {
  for (auto& [number, radar] : radars_) {
    if (radar.verdict == Verdict::kOpen || radar.is_assumed) {
      Judge(number, /*is_end=*/true, &radar);
    }
  }
  for (auto& [number, radar] : radars_) {
    if (IsDecided(number)) continue;
    if (sign_ == Sign::kUnknown || radar.num_moving > 0) {
      Guess(number);
    } else if (Seconds(radar.last_ns - radar.begin_ns) > kLongStanding) {
      Remark(true,
             NameOf(number) +
                 "by its Doppler the radar never moved, and the points do not tell "
                 "otherwise");
    }
  }
  Conclude();
}

void DopplerCheck::Conclude() {
  if (first_decided_) return;
  for (auto& [number, radar] : radars_) {
    if (!radar.is_assumed || radar.why_assumed.empty()) continue;
    Remark(true, NameOf(number) + std::exchange(radar.why_assumed, ""));
  }
}

std::optional<Eigen::Vector3d> DopplerCheck::MotionOfPoints(const RadarScan& scan) const {
  const auto entry = radars_.find(scan.radar);
  if (entry == radars_.end() || Factor(scan.radar) != 0) return std::nullopt;
  const std::deque<PlaneVelocity>& motion = entry->second.motion_of_points;
  const auto time_to = [&scan](const PlaneVelocity& velocity) {
    return std::abs(Seconds(velocity.stamp_ns - scan.stamp_ns));
  };
  const auto nearest = std::min_element(
      motion.begin(), motion.end(), [&](const PlaneVelocity& a, const PlaneVelocity& b) {
        return time_to(a) < time_to(b);
      });
  if (nearest == motion.end() || time_to(*nearest) > kVelocityHolds) return std::nullopt;
  const Eigen::Vector3d v_vehicle(nearest->v_vehicle.x(), nearest->v_vehicle.y(), 0.0);
  return sensor_.ForRadar(scan.radar).T_vehicle_radar().rotation.conjugate() * v_vehicle;
}

void DopplerCheck::Apply(RadarScan* scan) const {
  if (!scan->has_doppler) return;
  const int factor = Factor(scan->radar);
  if (factor == 0) scan->has_doppler = false;
  if (factor < 0) {
    for (RadarReturn& ret : scan->returns) ret.doppler = -ret.doppler;
  }
}

}  // namespace radive
