// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/marginal_covariance.h"

#include <ceres/covariance.h>
#include <glog/logging.h>

#include <utility>
#include <vector>

namespace radive {

std::optional<Eigen::MatrixXd> MarginalCovariance(ceres::Problem* problem, const double* block) {
  CHECK(problem != nullptr);
  if (!problem->HasParameterBlock(block) || problem->IsParameterBlockConstant(block)) {
    return std::nullopt;
  }
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::DENSE_SVD;
  options.null_space_rank = -1;  // drop unobserved directions instead of failing
  options.min_reciprocal_condition_number = 1e-14;
  ceres::Covariance covariance(options);
  const std::vector<std::pair<const double*, const double*>> wanted = {{block, block}};
  if (!covariance.Compute(wanted, problem)) return std::nullopt;

  const int size = problem->ParameterBlockTangentSize(block);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(size, size);
  if (!covariance.GetCovarianceBlockInTangentSpace(block, block, result.data())) {
    return std::nullopt;
  }
  return result;
}

Eigen::MatrixXd RotationVectorCovariance(const Eigen::MatrixXd& tangent_covariance) {
  CHECK_GE(tangent_covariance.rows(), 3);
  CHECK_EQ(tangent_covariance.rows(), tangent_covariance.cols());
  Eigen::MatrixXd result = tangent_covariance;
  result.topRows(3) *= 2.0;
  result.leftCols(3) *= 2.0;
  return result;
}

}  // namespace radive
