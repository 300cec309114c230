// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/factors/condensed_ndt_cost.h"

#include <ceres/jet.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/factors/ndt_pair_factor.h"
#include "radive/kernels/kernels.h"

namespace radive {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kTwoPiCubed = 248.05021344239853;

// Of the upper triangle.
Matrix6d Symmetric(const double (&upper)[6][6]) {
  Matrix6d full;
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column) {
      full(row, column) = full(column, row) = upper[row][column];
    }
  }
  return full;
}

// Mean and covariance of a Gaussian as one lane of nine.
void SetLane(const Eigen::Vector3d& mean,
             const Eigen::Matrix3d& covariance,
             int lane,
             Lanes* fields) {
  for (int i = 0; i < 3; ++i) fields[i].value[lane] = mean[i];
  fields[3].value[lane] = covariance(0, 0);
  fields[4].value[lane] = covariance(0, 1);
  fields[5].value[lane] = covariance(0, 2);
  fields[6].value[lane] = covariance(1, 1);
  fields[7].value[lane] = covariance(1, 2);
  fields[8].value[lane] = covariance(2, 2);
}

// What steps are taken by: the curvature, with which they converge fast, or as much of the way to
// it as leaves a share of the hessian in every direction.
Matrix6d StepMatrix(const NdtQuadratic& quadratic) {
  constexpr double kSmallestShare = 0.1;
  const Matrix6d pull = quadratic.hessian - quadratic.curvature;
  Matrix6d H = quadratic.hessian;
  for (double part = 1.0; part > 0.0; part -= 0.1) {
    const Matrix6d rest = (1.0 - kSmallestShare) * quadratic.hessian - part * pull;
    if (Eigen::LLT<Matrix6d>(rest).info() == Eigen::Success) {
      H -= part * pull;
      break;
    }
  }
  // A scan may leave directions unobserved: a tiny multiple of the identity keeps H invertible.
  H.diagonal().array() += 1e-9 * (1.0 + H.diagonal().maxCoeff());
  return H;
}

}  // namespace

CondensedNdtCost::CondensedNdtCost(const std::vector<Gaussian3>& scan,
                                   const std::vector<Gaussian3>& submap,
                                   const std::vector<NdtPair>& pairs,
                                   const Eigen::Vector3d& origin,
                                   NdtNormalisation normalisation,
                                   NdtDerivatives derivatives)
    : scan_(scan),
      submap_(submap),
      pairs_(pairs),
      origin_(origin),
      normalisation_(normalisation),
      derivatives_(derivatives) {
  for (const NdtPair& pair : pairs) {
    const Gaussian3& a = scan[static_cast<std::size_t>(pair.scan)];
    const Gaussian3& b = submap[static_cast<std::size_t>(pair.submap)];
    double depth = a.weight * b.confidence;
    if (normalisation == NdtNormalisation::kPaper) {
      const double bound = NdtPairFactor::DeterminantBound(a.covariance, b.covariance);
      depth /= std::sqrt(kTwoPiCubed * bound);
    }
    offset_ += depth;
  }
  if (derivatives == NdtDerivatives::kAnalytic) MakePacks();
}

// Scan Gaussians with about as many pairs go into one pack: few rows are left half empty.
void CondensedNdtCost::MakePacks() {
  struct Run {
    std::size_t begin, end;  // the pairs of one scan Gaussian
  };
  std::vector<Run> runs;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (k == 0 || pairs_[k].scan != pairs_[k - 1].scan) runs.push_back({k, k});
    ++runs.back().end;
  }
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.end - a.begin > b.end - b.begin;
  });
  constexpr std::size_t kLanes = 4;
  num_rows_.reserve((runs.size() + kLanes - 1) / kLanes);
  std::size_t num_rows = 0;
  for (std::size_t i = 0; i < runs.size(); i += kLanes) {
    num_rows_.push_back(static_cast<int>(runs[i].end - runs[i].begin));
    num_rows += runs[i].end - runs[i].begin;
  }
  scan_packs_.resize(num_rows_.size() * NdtPacks::kScanFields);
  pair_packs_.resize(num_rows * NdtPacks::kPairFields);
  const double normaliser =
      normalisation_ == NdtNormalisation::kPaper ? 1.0 / std::sqrt(kTwoPiCubed) : 1.0;
  Lanes* rows = pair_packs_.data();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    const int lane = static_cast<int>(i % kLanes);
    const Gaussian3& a = scan_[static_cast<std::size_t>(pairs_[run.begin].scan)];
    SetLane(a.mean, a.covariance, lane, &scan_packs_[i / kLanes * NdtPacks::kScanFields]);
    Lanes* row = rows;
    for (std::size_t k = run.begin; k < run.end; ++k, row += NdtPacks::kPairFields) {
      const Gaussian3& b = submap_[static_cast<std::size_t>(pairs_[k].submap)];
      SetLane(b.mean - origin_, b.covariance, lane, row);
      row[9].value[lane] = a.weight * b.confidence * normaliser;
    }
    if (i % kLanes + 1 == kLanes) rows += num_rows_[i / kLanes] * NdtPacks::kPairFields;
  }
}

NdtQuadratic CondensedNdtCost::AnalyticQuadratic(const double* pose) const {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R =
      Eigen::Map<const Eigen::Quaterniond>(pose).toRotationMatrix();
  NdtPacks packs;
  packs.scan = scan_packs_.data();
  packs.pairs = pair_packs_.data();
  packs.num_rows = num_rows_.data();
  packs.num_packs = static_cast<int>(num_rows_.size());
  packs.divides_by_determinant = normalisation_ == NdtNormalisation::kPaper;
  NdtSums sums;
  ActiveKernels().sum_ndt_pairs(packs, R.data(), pose + 4, &sums);
  NdtQuadratic result;
  result.cost = offset_ - sums.height;
  result.gradient = Eigen::Map<const Vector6d>(sums.gradient);
  result.hessian = Symmetric(sums.hessian);
  result.curvature = result.hessian - Symmetric(sums.off_centre);
  result.scatter = Symmetric(sums.scatter);
  return result;
}

NdtQuadratic CondensedNdtCost::AutodiffQuadratic(const double* pose) const {
  using Jet = ceres::Jet<double, 6>;
  const Eigen::Quaterniond q0 = Eigen::Map<const Eigen::Quaterniond>(pose);
  const Eigen::Matrix3d R0 = q0.toRotationMatrix();
  // (I + [dr]_x) R and t + dt are exact to first order, which is all that Jets carry.
  Eigen::Matrix<Jet, 3, 3> perturbation = Eigen::Matrix3d::Identity().cast<Jet>();
  perturbation(2, 1) += Jet(0.0, 0);
  perturbation(1, 2) -= Jet(0.0, 0);
  perturbation(0, 2) += Jet(0.0, 1);
  perturbation(2, 0) -= Jet(0.0, 1);
  perturbation(1, 0) += Jet(0.0, 2);
  perturbation(0, 1) -= Jet(0.0, 2);
  const Eigen::Matrix<Jet, 3, 3> R = perturbation * R0.cast<Jet>();
  Eigen::Matrix<Jet, 3, 1> t;
  for (int i = 0; i < 3; ++i) t[i] = Jet(pose[4 + i] + origin_[i], 3 + i);

  NdtQuadratic result;
  std::size_t k = 0;
  while (k < pairs_.size()) {
    const int index = pairs_[k].scan;
    const Gaussian3& a = scan_[static_cast<std::size_t>(index)];
    const Eigen::Matrix<Jet, 3, 1> rotated = R * a.mean.cast<Jet>();
    const Eigen::Matrix<Jet, 3, 3> covariance = R * a.covariance.cast<Jet>() * R.transpose();
    Vector6d gradient_of_scan = Vector6d::Zero();
    for (; k < pairs_.size() && pairs_[k].scan == index; ++k) {
      const Gaussian3& b = submap_[static_cast<std::size_t>(pairs_[k].submap)];
      const NdtPairFactor factor(a, b, normalisation_);
      Jet residuals[4];
      factor.Residuals<Jet>(rotated, covariance, t, residuals);
      Eigen::Vector4d r;
      Eigen::Matrix<double, 4, 6> J;
      for (int i = 0; i < 4; ++i) {
        r[i] = residuals[i].a;
        J.row(i) = residuals[i].v.transpose();
      }
      double rho[3];
      NdtPairLoss(a.weight * b.confidence * factor.WellDepth()).Evaluate(r.squaredNorm(), rho);
      result.cost += 0.5 * rho[0];
      const Vector6d half_slope = J.transpose() * r;  // of |r|^2
      gradient_of_scan += rho[1] * half_slope;
      result.hessian += rho[1] * J.transpose() * J;
      result.curvature +=
          rho[1] * J.transpose() * J + 2.0 * rho[2] * half_slope * half_slope.transpose();
    }
    result.gradient += gradient_of_scan;
    result.scatter += gradient_of_scan * gradient_of_scan.transpose();
  }
  return result;
}

const NdtQuadratic& CondensedNdtCost::At(const double* pose) const {
  const auto is_here = [pose](const Evaluation& known) {
    return std::equal(known.pose.begin(), known.pose.end(), pose);
  };
  const auto known = std::find_if(evaluations_.begin(), evaluations_.end(), is_here);
  if (known != evaluations_.end()) return known->quadratic;
  if (evaluations_.size() < 2) evaluations_.emplace_back();
  std::swap(evaluations_.front(), evaluations_.back());
  Evaluation& latest = evaluations_.front();
  std::copy_n(pose, latest.pose.size(), latest.pose.begin());
  latest.quadratic =
      derivatives_ == NdtDerivatives::kAnalytic ? AnalyticQuadratic(pose) : AutodiffQuadratic(pose);
  return latest.quadratic;
}

NdtQuadratic CondensedNdtCost::Quadratic(const double* pose) const { return At(pose); }

bool CondensedNdtCost::Evaluate(double const* const* parameters,
                                double* residuals,
                                double** jacobians) const {
  const double* pose = parameters[0];
  Eigen::Map<Eigen::Matrix<double, 7, 1>> r(residuals);
  if (jacobians == nullptr || jacobians[0] == nullptr) {
    // Without derivatives only |r| matters: a trial step asks for the cost alone.
    r.setZero();
    r[6] = std::sqrt(2.0 * (At(pose).cost + offset_));
    return std::isfinite(r[6]);
  }
  const NdtQuadratic& quadratic = At(pose);
  Matrix6d H = StepMatrix(quadratic);
  Eigen::LLT<Matrix6d> llt(H);
  Vector6d head = llt.matrixL().solve(quadratic.gradient);
  const double total = 2.0 * (quadratic.cost + offset_);
  if (head.squaredNorm() > total) {
    // A larger H is a more careful step; the residuals shrink by the root of its factor.
    const double scale = 1.01 * head.squaredNorm() / total;
    H *= scale;
    llt.compute(H);
    head /= std::sqrt(scale);
  }
  r.head<6>() = head;
  r[6] = std::sqrt(std::max(0.0, total - head.squaredNorm()));

  // From the tangent space to the block of seven: a change dq of the quaternion is the rotation
  // vector 2 vec(dq q^-1).
  const Eigen::Map<const Eigen::Quaterniond> q(pose);
  Eigen::Matrix<double, 3, 4> rotation_from_quaternion;
  rotation_from_quaternion << q.w(), -q.z(), q.y(), -q.x(),  //
      q.z(), q.w(), -q.x(), -q.y(),                          //
      -q.y(), q.x(), q.w(), -q.z();
  const Matrix6d J = llt.matrixU();
  Eigen::Map<Eigen::Matrix<double, 7, 7, Eigen::RowMajor>> jacobian(jacobians[0]);
  jacobian.setZero();
  jacobian.topLeftCorner<6, 4>() = 2.0 * J.leftCols<3>() * rotation_from_quaternion;
  jacobian.topRightCorner<6, 3>() = J.rightCols<3>();
  return llt.info() == Eigen::Success && r.allFinite();
}

}  // namespace radive
