// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

#include <glog/logging.h>

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "radive/geometry/pose_covariance.h"
#include "radive/odometry/motion_fusion.h"
#include "radive/odometry/radar_odometry.h"

namespace radive {

const char* ToString(OdometryResult::Status status) {
  switch (status) {
    case OdometryResult::Status::kRegistered:
      return "registered";
    case OdometryResult::Status::kPredicted:
      return "predicted";
    case OdometryResult::Status::kStanding:
      return "standing";
    case OdometryResult::Status::kSkipped:
      return "skipped";
  }
  return "unknown";
}

class Odometry::Impl {
 public:
  explicit Impl(const OdometryOptions& options) : options_(options) {
    std::string error;
    CHECK(options.IsValid(&error)) << error;
  }

  OdometryResult AddScan(const RadarScan& scan);
  void StartMotion(int radar, const Eigen::Vector3d& v_radar) {
    RadarOf(radar)->odometry.StartMotion(v_radar);
  }
  std::vector<std::string> TakeNotes() { return std::exchange(notes_, {}); }
  std::vector<std::string> TakeWarnings() { return std::exchange(warnings_, {}); }
  std::vector<RadarSurface> TakeSurfaces();

 private:
  struct Radar {
    RadarOdometry odometry;
    Rigid3 T_body_radar;
    bool is_body = false;
    Rigid3 T_world_own;  // own: the world frame of its odometry
  };

  Radar* RadarOf(int number);
  void TakeNotesOf(RadarOdometry* odometry);
  // From the radar's own world frame to that of the trajectory.
  void PlaceInWorld(int number, Radar* radar, OdometryResult* result);

  const OdometryOptions options_;
  std::map<int, Radar> radars_;            // by the number that scans give
  std::optional<Rigid3> T_vehicle_first_;  // the first radar
  MotionFusion fusion_;
  Rigid3 T_world_body_;  // at the last scan
  int num_scans_ = 0;
  std::optional<std::int64_t> last_stamp_ns_;
  std::set<std::string> known_notes_;
  std::vector<std::string> notes_;
  std::vector<std::string> warnings_;
};

Odometry::Impl::Radar* Odometry::Impl::RadarOf(int number) {
  const auto known = radars_.find(number);
  if (known != radars_.end()) return &known->second;
  OdometryOptions options = options_;
  options.sensor = options.sensor.ForRadar(number);
  const Rigid3 T_vehicle_radar = options.sensor.T_vehicle_radar();
  if (!T_vehicle_first_) T_vehicle_first_ = T_vehicle_radar;
  const bool is_vehicle = options.motion.body == MotionOptions::Body::kVehicle;
  const Rigid3 T_body_radar =
      is_vehicle ? T_vehicle_radar : T_vehicle_first_->Inverse() * T_vehicle_radar;
  const bool is_body = !is_vehicle && radars_.empty();
  return &radars_.emplace(number, Radar{RadarOdometry(options), T_body_radar, is_body, Rigid3()})
              .first->second;
}

// Once, where several radars say the same.
void Odometry::Impl::TakeNotesOf(RadarOdometry* odometry) {
  for (std::string& note : odometry->TakeNotes()) {
    if (known_notes_.insert(note).second) notes_.push_back(std::move(note));
  }
}

void Odometry::Impl::PlaceInWorld(int number, Radar* radar, OdometryResult* result) {
  const Rigid3 T_own_radar = result->T_world_radar;
  const Rigid3 T_radar_body = radar->T_body_radar.Inverse();
  Rigid3 T_own_body = T_own_radar;
  if (!radar->is_body) {
    // The radar's own world is its frame at its first scan; now it is the body's then.
    T_own_body = radar->T_body_radar * T_own_radar * T_radar_body;
    result->covariance = TurnedCovariance(
        radar->T_body_radar.RotationMatrix(),
        CovarianceAtLever(result->covariance, T_own_radar.rotation * T_radar_body.translation));
  }
  const Eigen::Vector3d velocity = radar->T_body_radar.rotation * result->ego_velocity.v_radar;
  if (result->status == OdometryResult::Status::kPredicted) {
    fusion_.AddPredicted(number, result->stamp_ns, T_own_body, result->covariance, velocity);
  } else {
    fusion_.Add(number, result->stamp_ns, T_own_body, result->covariance, velocity);
  }
  if (radars_.size() == 1) {
    result->T_world_body = T_own_body;
  } else {
    result->T_world_body = fusion_.T_world_body();
    result->covariance = fusion_.covariance();
  }
  if (radar->is_body && radars_.size() == 1) return;
  result->T_world_radar = result->T_world_body * radar->T_body_radar;
  radar->T_world_own = result->T_world_radar * T_own_radar.Inverse();
  for (Eigen::Vector3d& point : result->keyframe_points) point = radar->T_world_own * point;
}

OdometryResult Odometry::Impl::AddScan(const RadarScan& scan) {
  Radar* const radar = RadarOf(scan.radar);
  OdometryResult result;
  if (last_stamp_ns_ && scan.stamp_ns < *last_stamp_ns_) {
    result.stamp_ns = scan.stamp_ns;
    result.num_returns = static_cast<int>(scan.returns.size());
    result.reason = "stamp goes back";
  } else {
    result = radar->odometry.AddScan(scan);
    TakeNotesOf(&radar->odometry);
    std::vector<std::string> warnings = radar->odometry.TakeWarnings();
    // Where another radar has given scans meanwhile, the motion is known from it.
    constexpr std::int64_t kShortTime = 1'000'000'000;
    if (last_stamp_ns_ && scan.stamp_ns - *last_stamp_ns_ > kShortTime) {
      for (std::string& warning : warnings) warnings_.push_back(std::move(warning));
    }
  }
  result.index = num_scans_++;
  if (result.status == OdometryResult::Status::kSkipped) {
    result.T_world_body = T_world_body_;
    result.T_world_radar = T_world_body_ * radar->T_body_radar;
    return result;
  }
  PlaceInWorld(scan.radar, radar, &result);
  T_world_body_ = result.T_world_body;
  last_stamp_ns_ = scan.stamp_ns;
  return result;
}

std::vector<RadarSurface> Odometry::Impl::TakeSurfaces() {
  std::vector<RadarSurface> surfaces;
  for (auto& [number, radar] : radars_) {
    std::optional<SurfaceRecord> record = radar.odometry.TakeSurfaceRecord();
    if (record) surfaces.push_back({radar.T_world_own, std::move(*record)});
  }
  return surfaces;
}

Odometry::Odometry(const OdometryOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

OdometryResult Odometry::AddScan(const RadarScan& scan) { return impl_->AddScan(scan); }
void Odometry::StartMotion(int radar, const Eigen::Vector3d& v_radar) {
  impl_->StartMotion(radar, v_radar);
}
std::vector<std::string> Odometry::TakeNotes() { return impl_->TakeNotes(); }
std::vector<std::string> Odometry::TakeWarnings() { return impl_->TakeWarnings(); }
std::vector<RadarSurface> Odometry::TakeSurfaces() { return impl_->TakeSurfaces(); }

}  // namespace radive
