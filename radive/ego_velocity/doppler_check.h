// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/ego_velocity/doppler_evidence.h"
#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// What a DopplerCheck has found, for the log.
struct DopplerRemark {
  bool is_warning = false;
  std::string text;
};

// Compares the Doppler of a drive with the motion of its points, and says what to do with it:
// nothing, turn its sign, or leave it out. For each radar of the drive; a radar whose own points do
// not tell goes by what the others have found.
//
//   DopplerCheck check(sensor, preprocessing, DopplerCheck::Sign::kUnknown);
//   for (RadarScan scan : scans) {
//     check.Add(scan);
//     check.Apply(&scan);
//     odometry.AddScan(scan);
//   }
//
// Where scans can wait, as those of a file, those of a radar that moves should until IsDecided()
// (see DopplerCheckedSource). After that it goes on looking, a few scans in a minute, and changes
// what it said when the evidence turns.
class DopplerCheck {
 public:
  enum class Sign {
    kUnknown,  // to be found out
    kGiven     // that of the scans is right: what contradicts it is a fault
  };

  DopplerCheck(const SensorOptions& sensor,
               const PreprocessingOptions& preprocessing,
               Sign sign = Sign::kUnknown)
      : sensor_(sensor), preprocessing_(preprocessing), sign_(sign) {}

  // The next scan of the drive, its Doppler as stored.
  void Add(const RadarScan& scan);
  // No scan follows: judges by what there is.
  void Finish();
  // Of this drive nothing more will be used: warns of what is still assumed. Finish() does so too.
  void Conclude();

  // Whether it is known what to do with the Doppler of this radar.
  bool IsDecided(int radar) const;
  // Whether the radar stood at the scan, so that the sign does not matter: known some scans later.
  bool IsStanding(const RadarScan& scan) const;
  // Something has changed with the scans of this radar: they are looked at from the next one on.
  void LookAgain(int radar);
  // Gives up waiting for certainty: the Doppler is taken to have the sign that is likelier by the
  // points, or by which the vehicle drives forward where they say nothing.
  void Assume(int radar);

  // Velocity of the radar about at the scan as its points have it [m/s], radar frame, where the
  // Doppler is left out: what an odometry may start from. None where they do not tell.
  std::optional<Eigen::Vector3d> MotionOfPoints(const RadarScan& scan) const;

  // Turns the Doppler, or takes it out of the scan, as decided; until then leaves it as stored.
  void Apply(RadarScan* scan) const;

  // +1, -1, or 0: left out. +1 before it is decided.
  int Factor(int radar) const;

  // Cleared by the call.
  std::vector<DopplerRemark> TakeRemarks() { return std::exchange(remarks_, {}); }

 private:
  enum class Verdict { kOpen, kPlus, kMinus, kOff };

  struct PastScan {
    std::int64_t stamp_ns;
    VotingPoints points;
    DopplerFit fit;
  };

  struct PlaneVelocity {
    std::int64_t stamp_ns;
    Eigen::Vector2d v_vehicle;  // of the radar, vehicle's axes [m/s]
  };

  struct Radar {
    DopplerEvidence evidence;
    std::deque<PastScan> past;
    std::optional<std::int64_t> last_pair_ns;
    std::int64_t look_begin_ns = 0;              // of the present look
    std::optional<std::int64_t> next_look_ns;    // none as long as the first one lasts
    MeanTest look_advantage;                     // of its pairs, for what is decided
    MeanTest look_pattern;                       // 1 for scans with a pattern, 0 for those without
    bool is_doubted = false;                     // the evidence is that of this look alone
    double look_interval = 0.0;                  // to the next [s]
    std::deque<PlaneVelocity> motion_of_points;  // before the verdict
    std::int64_t begin_ns = 0, last_ns = 0;      // first and last scan
    std::int64_t standing_until_ns = INT64_MIN;
    Verdict verdict = Verdict::kOpen;  // by its own points
    bool is_assumed = false;           // the verdict is: it may change more easily
    std::string why_assumed;           // the warning, should nothing else be found
    double forward = 0.0;              // sum of the forward speed by the Doppler as stored [m/s]
    int num_moving = 0;                // scans that move by the Doppler
  };

  // By its own points, and for certain.
  static bool IsFirm(const Radar& radar);
  // Which scans of a radar are looked at.
  bool IsLookingAt(std::int64_t stamp_ns, int number, const Radar& radar) const;
  // Whether the present look contradicts what was decided by those before it.
  static bool IsContradicted(std::int64_t stamp_ns, const Radar& radar);
  // Ends the look of a radar that is firm when it has seen enough.
  static void EndLookIfDone(std::int64_t stamp_ns, Radar* radar);
  void AddPair(const PastScan& before, const PastScan& after, int number, Radar* radar) const;
  void Judge(int number, bool is_end, Radar* radar);
  void Decide(int number, const DopplerFinding& finding, Radar* radar);
  void WarnOfOtherAssumptions(int number);
  void Guess(int number);
  Verdict VerdictOf(int radar) const;
  std::string NameOf(int radar) const;
  void Remark(bool is_warning, const std::string& text) { remarks_.push_back({is_warning, text}); }

  const SensorOptions sensor_;
  const PreprocessingOptions preprocessing_;
  const Sign sign_;
  std::map<int, Radar> radars_;
  std::optional<int> first_decided_;  // whose verdict the others go by
  std::vector<DopplerRemark> remarks_;
};

}  // namespace radive
