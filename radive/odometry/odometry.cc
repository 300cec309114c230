// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

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
  explicit Impl(const OdometryOptions& options) : options_(options) {}
  OdometryOptions options_;
  int count_ = 0;
};

Odometry::Odometry(const OdometryOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

OdometryResult Odometry::AddScan(const RadarScan& scan) {
  OdometryResult result;
  result.index = impl_->count_++;
  result.stamp_ns = scan.stamp_ns;
  result.num_returns = static_cast<int>(scan.returns.size());
  return result;
}

std::vector<Eigen::Vector3d> Odometry::MapPoints() const { return {}; }
std::vector<std::string> Odometry::TakeNotes() { return {}; }

}  // namespace radive
