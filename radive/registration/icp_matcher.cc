// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/icp_matcher.h"

#include <ceres/problem.h>

#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "radive/factors/doppler_motion_factor.h"
#include "radive/factors/gicp_factor.h"
#include "radive/factors/ndt_pair_factor.h"
#include "radive/factors/point_to_plane_factor.h"
#include "radive/factors/point_to_point_factor.h"
#include "radive/geometry/sqrt_information.h"
#include "radive/registration/linearised.h"
#include "radive/registration/point_tree.h"

namespace radive {
namespace {

// Variance along the surface over that across it, of the discs of GICP (Segal et al. 2009).
constexpr double kDiscRatio = 1e3;

// One residual block a pair.
class FactorMatch : public ScanMatch {
 public:
  void Add(ceres::CostFunction* factor, double weight) {
    factors_.emplace_back(factor);
    losses_.emplace_back(weight);
  }
  void CountPair() { ++num_pairs_; }

  void AddTo(ceres::Problem* problem, double* pose) const override {
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      // Ceres asks for a mutable pointer and only evaluates.
      problem->AddResidualBlock(factors_[i].get(), const_cast<NdtPairLoss*>(&losses_[i]), pose);
    }
  }

  NdtQuadratic Quadratic(const double* pose) const override {
    NdtQuadratic sum;
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      const Linearised linearised = Linearise(*factors_[i], pose);
      double rho[3];
      losses_[i].Evaluate(linearised.residuals.squaredNorm(), rho);
      const Eigen::Matrix<double, 6, 1> half_slope =
          linearised.jacobian.transpose() * linearised.residuals;
      const Eigen::Matrix<double, 6, 6> information =
          linearised.jacobian.transpose() * linearised.jacobian;
      const Eigen::Matrix<double, 6, 1> gradient = rho[1] * half_slope;
      sum.cost += 0.5 * rho[0];
      sum.gradient += gradient;
      sum.hessian += rho[1] * information;
      sum.curvature += rho[1] * information + 2.0 * rho[2] * half_slope * half_slope.transpose();
      sum.scatter += gradient * gradient.transpose();
    }
    return sum;
  }

  int num_pairs() const override { return num_pairs_; }
  int num_scan_gaussians() const override { return num_pairs_; }

 private:
  std::vector<std::unique_ptr<ceres::CostFunction>> factors_;
  std::deque<NdtPairLoss> losses_;
  int num_pairs_ = 0;
};

std::vector<Eigen::Vector3d> Means(const std::vector<Gaussian3>& gaussians,
                                   const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector3d> means;
  means.reserve(gaussians.size());
  for (const Gaussian3& gaussian : gaussians) means.push_back(gaussian.mean - origin);
  return means;
}

// Normals of the surface that points sample, each found when it is first asked for.
class SurfaceNormals {
 public:
  // `up`: set for points of a sensor without elevation, their vertical.
  SurfaceNormals(const PointTree& tree, int neighbors, std::optional<Eigen::Vector3d> up)
      : tree_(tree), neighbors_(neighbors), up_(std::move(up)), known_(tree.points().size()) {}

  // Nothing where the neighbours make no surface.
  const std::optional<Eigen::Vector3d>& At(std::size_t i) {
    Entry& entry = known_[i];
    if (!entry.is_known) {
      const Eigen::Vector3d& p = tree_.points()[i];
      entry.normal = up_ ? tree_.NormalAcross(*up_, p, neighbors_) : tree_.Normal(p, neighbors_);
      entry.is_known = true;
    }
    return entry.normal;
  }

 private:
  struct Entry {
    bool is_known = false;
    std::optional<Eigen::Vector3d> normal;
  };
  const PointTree& tree_;
  const int neighbors_;
  const std::optional<Eigen::Vector3d> up_;
  std::vector<Entry> known_;
};

class IcpMatcher : public ScanMatcher {
 public:
  IcpMatcher(const RegistrationInput& input,
             const Eigen::Vector3d& origin,
             const PairOptions& pair_options,
             const RegistrationOptions& options)
      : input_(input),
        origin_(origin),
        max_distance_(pair_options.d_max),
        options_(options),
        submap_tree_(Means(input.search->submap(), origin)),
        submap_normals_(submap_tree_, options.icp_neighbors, UpIn(input.T_prediction)),
        scan_tree_(Means(*input.scan, Eigen::Vector3d::Zero())),
        scan_normals_(scan_tree_, options.icp_neighbors, UpIn(Rigid3())) {}

  std::unique_ptr<ScanMatch> Associate(const Rigid3& T_submap_radar, double /*slack*/) override {
    const Rigid3 T_origin_radar = {T_submap_radar.rotation, T_submap_radar.translation - origin_};
    const Eigen::Matrix3d R = T_submap_radar.RotationMatrix();
    auto match = std::make_unique<FactorMatch>();
    for (std::size_t i = 0; i < input_.scan->size(); ++i) {
      const Gaussian3& a = (*input_.scan)[i];
      const auto nearest = submap_tree_.Nearest(T_origin_radar * a.mean, max_distance_);
      if (!nearest) continue;
      ceres::CostFunction* factor = MakeFactor(i, *nearest, R);
      if (factor == nullptr) continue;
      match->Add(factor, a.weight * input_.search->submap()[*nearest].confidence);
      match->CountPair();
    }
    if (options_.method == RegistrationMethod::kDopplerIcp) AddDoppler(match.get());
    return match;
  }

  bool PairsDiffer(const Rigid3& /*from*/, const Rigid3& /*to*/) const override { return true; }
  bool associates_each_step() const override { return true; }

 private:
  std::optional<Eigen::Vector3d> UpIn(const Rigid3& T_frame_radar) const {
    if (!input_.is_planar) return std::nullopt;
    return T_frame_radar.rotation * Eigen::Vector3d::UnitZ();
  }

  void AddDoppler(FactorMatch* match) const {
    if (!input_.doppler) return;
    const RegistrationInput::Doppler& doppler = *input_.doppler;
    const Rigid3 T_origin_radar0 = {doppler.T_submap_radar0.rotation,
                                    doppler.T_submap_radar0.translation - origin_};
    for (std::size_t i = 0; i < doppler.returns->size(); ++i) {
      const RadarReturn& measured = (*doppler.returns)[i];
      const double range = measured.position.norm();
      if (!std::isfinite(measured.doppler) || !(range > 0.0)) continue;
      match->Add(DopplerMotionFactor::Create(T_origin_radar0,
                                             doppler.dt,
                                             measured.position / range,
                                             measured.doppler,
                                             doppler.sigma),
                 (*doppler.weights)[i]);
    }
  }

  // Standard deviations along the normal add up to icp_sigma over both sides.
  Eigen::Matrix3d Disc(const Eigen::Vector3d& normal) const {
    const double variance = 0.5 * options_.icp_sigma * options_.icp_sigma;
    return kDiscRatio * variance * Eigen::Matrix3d::Identity() -
           (kDiscRatio - 1.0) * variance * normal * normal.transpose();
  }

  // Of scan point i and submap point j, at the rotation R; nullptr where a surface is missing.
  ceres::CostFunction* MakeFactor(std::size_t i, std::size_t j, const Eigen::Matrix3d& R) {
    const Eigen::Vector3d& p = scan_tree_.points()[i];
    const Eigen::Vector3d& q = submap_tree_.points()[j];
    if (options_.method == RegistrationMethod::kIcp) {
      return PointToPointFactor::Create(p, q, options_.icp_sigma);
    }
    const std::optional<Eigen::Vector3d>& normal = submap_normals_.At(j);
    if (!normal) return nullptr;
    if (options_.method != RegistrationMethod::kGicp) {
      return PointToPlaneFactor::Create(p, q, *normal, options_.icp_sigma);
    }
    const std::optional<Eigen::Vector3d>& normal_scan = scan_normals_.At(i);
    if (!normal_scan) return nullptr;
    return GicpFactor::Create(p, q, SqrtInformation<3>(Disc(R * *normal_scan) + Disc(*normal)));
  }

  const RegistrationInput& input_;
  const Eigen::Vector3d origin_;
  const double max_distance_;  // [m]
  const RegistrationOptions options_;
  const PointTree submap_tree_;  // relative to origin_
  SurfaceNormals submap_normals_;
  const PointTree scan_tree_;
  SurfaceNormals scan_normals_;
};

}  // namespace

std::unique_ptr<ScanMatcher> MakeIcpMatcher(const RegistrationInput& input,
                                            const Eigen::Vector3d& origin,
                                            const PairOptions& pair_options,
                                            const RegistrationOptions& options) {
  return std::make_unique<IcpMatcher>(input, origin, pair_options, options);
}

}  // namespace radive
