// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_sign.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kGate = 0.5;        // Doppler residual of an inlier [m/s]
constexpr double kMinSpeed = 1.0;    // of a moving scan [m/s]
constexpr double kMinForward = 0.5;  // median forward component that decides [m/s]
constexpr double kMinInlierShare = 0.5;
constexpr std::size_t kMinReturns = 8;
constexpr int kDraws = 50;
constexpr int kMinMovingScans = 5;
constexpr double kMinAgreement = 0.8;  // share of the moving scans that go the median's way

// Least squares of doppler = -d . v over the chosen rows.
Eigen::Vector3d SolveVelocity(const Eigen::MatrixX3d& directions,
                              const Eigen::VectorXd& doppler,
                              const std::vector<Eigen::Index>& rows) {
  Eigen::Matrix3d normal = 1e-6 * Eigen::Matrix3d::Identity();  // a plane leaves z at zero
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Index row : rows) {
    normal += directions.row(row).transpose() * directions.row(row);
    right -= directions.row(row).transpose() * doppler[row];
  }
  return normal.ldlt().solve(right);
}

std::vector<Eigen::Index> Inliers(const Eigen::MatrixX3d& directions,
                                  const Eigen::VectorXd& doppler,
                                  const Eigen::Vector3d& v_radar) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < doppler.size(); ++row) {
    if (std::abs(doppler[row] + directions.row(row).dot(v_radar)) < kGate) rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::optional<Eigen::Vector3d> FitVelocity(const RadarScan& scan) {
  std::vector<const RadarReturn*> usable;
  for (const RadarReturn& ret : scan.returns) {
    if (ret.position.allFinite() && std::isfinite(ret.doppler) && ret.position.norm() > 1e-3) {
      usable.push_back(&ret);
    }
  }
  if (usable.size() < kMinReturns) return std::nullopt;
  Eigen::MatrixX3d directions(usable.size(), 3);
  Eigen::VectorXd doppler(usable.size());
  for (std::size_t i = 0; i < usable.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    directions.row(row) = usable[i]->position.normalized().transpose();
    doppler[row] = usable[i]->doppler;
  }
  Random random(1);
  std::vector<Eigen::Index> best;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<Eigen::Index> sample;
    for (int i = 0; i < 3; ++i) {
      sample.push_back(static_cast<Eigen::Index>(random.Index(usable.size())));
    }
    std::vector<Eigen::Index> rows =
        Inliers(directions, doppler, SolveVelocity(directions, doppler, sample));
    if (rows.size() > best.size()) best = std::move(rows);
  }
  if (static_cast<double>(best.size()) < kMinInlierShare * static_cast<double>(usable.size())) {
    return std::nullopt;
  }
  return SolveVelocity(directions, doppler, best);
}

ScanSource::Status DopplerSignSource::ReadNext(RadarScan* scan) {
  const Status status = source_->Next(scan);
  for (std::string& warning : source_->TakeWarnings()) warnings_.push_back(std::move(warning));
  if (status == Status::kError) error_ = source_->error();
  return status;
}

ScanSource::Status DopplerSignSource::Next(RadarScan* scan) {
  if (!has_looked_) {
    has_looked_ = true;
    while (held_back_.size() < kMaxScans) {
      RadarScan next;
      status_after_held_back_ = ReadNext(&next);
      if (status_after_held_back_ != Status::kScan) break;
      held_back_.push_back(std::move(next));
    }
    Decide();
  }
  if (!held_back_.empty()) {
    *scan = std::move(held_back_.front());
    held_back_.pop_front();
  } else {
    if (status_after_held_back_ != Status::kScan) return status_after_held_back_;
    const Status status = ReadNext(scan);
    if (status != Status::kScan) return status;
  }
  if (sign_ < 0.0) {
    for (RadarReturn& ret : scan->returns) ret.doppler = -ret.doppler;
  }
  return Status::kScan;
}

void DopplerSignSource::Decide() {
  std::vector<double> forward;  // of the moving scans [m/s]
  bool has_doppler = false;
  for (const RadarScan& scan : held_back_) {
    has_doppler = has_doppler || scan.has_doppler;
    const std::optional<Eigen::Vector3d> v_radar =
        scan.has_doppler ? FitVelocity(scan) : std::nullopt;
    if (v_radar && v_radar->norm() > kMinSpeed) forward.push_back(forward_radar_.dot(*v_radar));
  }
  if (!has_doppler) {
    is_decided_ = true;  // nothing to turn
    evidence_ = "the scans carry no Doppler, so its sign does not matter";
    return;
  }
  const int moving = static_cast<int>(forward.size());
  std::sort(forward.begin(), forward.end());
  const double median = forward.empty() ? 0.0 : forward[forward.size() / 2];
  const auto agreeing = std::count_if(
      forward.begin(), forward.end(), [median](double v) { return v * median > 0.0; });
  is_decided_ = moving >= kMinMovingScans && std::abs(median) >= kMinForward &&
                static_cast<double>(agreeing) >= kMinAgreement * moving;
  if (is_decided_ && median < 0.0) sign_ = -1.0;
  char text[200];
  std::snprintf(text,
                sizeof(text),
                "Doppler sign %s: as stored, the median forward speed is %.2f m/s over %d moving "
                "of the first %d scans, %d of which agree",
                is_decided_ ? (sign_ < 0.0 ? "-1" : "+1") : "undecided, +1 assumed",
                median,
                moving,
                static_cast<int>(held_back_.size()),
                static_cast<int>(agreeing));
  evidence_ = text;
}

}  // namespace radive
