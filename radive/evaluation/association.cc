// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/association.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "radive/evaluation/nearest_value.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

std::string TimeSpan(const RecordedTrajectory& trajectory) {
  if (trajectory.empty()) return "is empty";
  const auto [first, last] =
      std::minmax_element(trajectory.begin(), trajectory.end(), [](const auto& a, const auto& b) {
        return a.stamp_ns < b.stamp_ns;
      });
  return "spans " + FormatStamp(first->stamp_ns) + " to " + FormatStamp(last->stamp_ns) + " s";
}

// The stamps of a trajectory in ascending order, and where each stood in the file.
struct SortedStamps {
  explicit SortedStamps(const RecordedTrajectory& trajectory) : order(trajectory.size()) {
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return trajectory[a].stamp_s < trajectory[b].stamp_s;
    });
    for (const std::size_t i : order) stamps.push_back(trajectory[i].stamp_s);
  }

  std::vector<std::size_t> order;
  std::vector<double> stamps;
};

// From an earlier stamp to a later one [s]. Without a sign: hostile stamps lie far apart.
double SecondsBetween(std::int64_t earlier_ns, std::int64_t later_ns) {
  return 1e-9 * static_cast<double>(static_cast<std::uint64_t>(later_ns) -
                                    static_cast<std::uint64_t>(earlier_ns));
}

// Between two poses, `share` of the way.
MatrixPose InterpolatePose(const RecordedPose& first, const RecordedPose& second, double share) {
  const Eigen::Quaterniond q0(first.T_world_body.rotation), q1(second.T_world_body.rotation);
  const Eigen::Vector3d& p0 = first.T_world_body.translation;
  const Eigen::Vector3d& p1 = second.T_world_body.translation;
  return {q0.normalized().slerp(share, q1.normalized()).toRotationMatrix(), p0 + share * (p1 - p0)};
}

}  // namespace

std::optional<MatchedPoses> AssociateByStamp(const RecordedTrajectory& reference,
                                             const RecordedTrajectory& estimate,
                                             double max_time_difference,
                                             std::string* error) {
  const bool estimate_is_short = estimate.size() <= reference.size();
  const RecordedTrajectory& short_one = estimate_is_short ? estimate : reference;
  const RecordedTrajectory& long_one = estimate_is_short ? reference : estimate;

  MatchedPoses matched;
  const SortedStamps sorted(long_one);
  for (const RecordedPose& pose : short_one) {
    const std::size_t nearest = NearestAscending(sorted.stamps, 0, pose.stamp_s);
    if (std::abs(sorted.stamps[nearest] - pose.stamp_s) > max_time_difference) continue;
    const RecordedPose& partner = long_one[sorted.order[nearest]];
    matched.reference.push_back(estimate_is_short ? partner.T_world_body : pose.T_world_body);
    matched.estimate.push_back(estimate_is_short ? pose.T_world_body : partner.T_world_body);
  }
  if (matched.reference.empty()) {
    *error = "no stamps of reference and estimate lie within " + NumberText(max_time_difference) +
             " s: the reference " + TimeSpan(reference) + ", the estimate " + TimeSpan(estimate);
    return std::nullopt;
  }
  return matched;
}

std::optional<MatchedPoses> AssociateByIndex(const RecordedTrajectory& reference,
                                             const RecordedTrajectory& estimate,
                                             std::string* error) {
  if (reference.size() != estimate.size() || reference.empty()) {
    *error =
        "expected as many poses in the estimate as in the reference, because the format has "
        "no stamps; found " +
        std::to_string(estimate.size()) + " and " + std::to_string(reference.size());
    return std::nullopt;
  }
  MatchedPoses matched;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    matched.reference.push_back(reference[i].T_world_body);
    matched.estimate.push_back(estimate[i].T_world_body);
  }
  return matched;
}

std::optional<MatchedPoses> AssociateInterpolated(const RecordedTrajectory& reference,
                                                  const RecordedTrajectory& estimate,
                                                  double max_gap,
                                                  std::string* error) {
  RecordedTrajectory sorted = reference;
  const auto is_earlier = [](const RecordedPose& a, const RecordedPose& b) {
    return a.stamp_ns < b.stamp_ns;
  };
  std::stable_sort(sorted.begin(), sorted.end(), is_earlier);
  MatchedPoses matched;
  for (const RecordedPose& pose : estimate) {
    const auto after = std::lower_bound(sorted.begin(), sorted.end(), pose, is_earlier);
    if (after == sorted.end()) continue;
    if (after->stamp_ns == pose.stamp_ns) {
      matched.reference.push_back(after->T_world_body);
    } else {
      if (after == sorted.begin()) continue;
      const auto before = std::prev(after);
      const double gap = SecondsBetween(before->stamp_ns, after->stamp_ns);
      const double time = SecondsBetween(before->stamp_ns, pose.stamp_ns);
      if (gap > max_gap) continue;
      matched.reference.push_back(InterpolatePose(*before, *after, time / gap));
    }
    matched.estimate.push_back(pose.T_world_body);
  }
  if (!matched.reference.empty()) return matched;
  *error = "no pose of the estimate lies between two of the reference within " +
           NumberText(max_gap) + " s: the reference " + TimeSpan(reference) + ", the estimate " +
           TimeSpan(estimate);
  return std::nullopt;
}

}  // namespace radive
