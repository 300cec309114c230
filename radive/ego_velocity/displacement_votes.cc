// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/displacement_votes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kCell = 0.25;      // of the grid of displacements [m]
constexpr double kTurnStep = 0.02;  // [rad]

// Points meet within these distances along and across the line of sight: ranges are measured more
// precisely than angles [cells, to both sides together].
constexpr int kAlongCells = 2;
constexpr int kAcrossCells = 6;

// Votes are counted this far beyond the reach, so that each displacement has its whole box.
constexpr int kMargin = kAcrossCells / 2;
constexpr int kReachCells = static_cast<int>(DisplacementVotes::kReach / kCell);
constexpr int kPlaces = 2 * kReachCells + 1;               // displacements along an axis
constexpr int kCorners = 2 * (kReachCells + kMargin) + 1;  // of the cells that are counted
constexpr double kCounted = (kReachCells + kMargin) * kCell;

// The top around the most votes [cells to each side, share of them].
constexpr int kTop = 6;
constexpr double kTopShare = 0.85;

constexpr double kSquare = 0.5;     // of which one point is kept [m]
constexpr double kNearby = 2.0;     // neighbours share their weight [m]
constexpr double kFarthest = 80.0;  // [m]

struct WeightedPoint {
  Eigen::Vector2d position;
  float weight;
};

std::size_t Corner(int column, int row) {
  return static_cast<std::size_t>(row * kCorners + column);
}

std::vector<WeightedPoint> Turned(const VotingPoints& points, double angle) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  std::vector<WeightedPoint> turned;
  turned.reserve(points.positions.size());
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    turned.push_back({R * points.positions[i], static_cast<float>(points.weights[i])});
  }
  return turned;
}

// The votes of one turn as sums to the left of and below each corner, so that those in a box take
// four numbers: of points that lie ahead or behind, and of points to the sides.
struct VoteSums {
  std::vector<float> ahead = std::vector<float>(Corner(0, kCorners));
  std::vector<float> aside = std::vector<float>(Corner(0, kCorners));
};

void SumUp(std::vector<float>* votes) {
  for (int row = 1; row < kCorners; ++row) {
    float of_row = 0.0F;
    for (int column = 1; column < kCorners; ++column) {
      of_row += (*votes)[Corner(column, row)];
      (*votes)[Corner(column, row)] = of_row + (*votes)[Corner(column, row - 1)];
    }
  }
}

VoteSums CountVotes(std::vector<WeightedPoint> before, const std::vector<WeightedPoint>& after) {
  std::sort(before.begin(), before.end(), [](const WeightedPoint& a, const WeightedPoint& b) {
    return std::make_tuple(a.position.x(), a.position.y()) <
           std::make_tuple(b.position.x(), b.position.y());
  });
  VoteSums sums;
  for (const WeightedPoint& p_after : after) {
    const Eigen::Vector2d& p = p_after.position;
    std::vector<float>& votes = std::abs(p.x()) > std::abs(p.y()) ? sums.ahead : sums.aside;
    auto p_before = std::lower_bound(
        before.begin(), before.end(), p.x() - kCounted, [](const WeightedPoint& a, double x) {
          return a.position.x() < x;
        });
    for (; p_before != before.end(); ++p_before) {
      const Eigen::Vector2d cell =
          (p_before->position - p + Eigen::Vector2d::Constant(kCounted)) / kCell;
      if (cell.x() >= kCorners - 1) break;
      if (cell.y() < 0.0 || cell.y() >= kCorners - 1) continue;
      votes[Corner(static_cast<int>(cell.x()) + 1, static_cast<int>(cell.y()) + 1)] +=
          p_before->weight * p_after.weight;
    }
  }
  SumUp(&sums.ahead);
  SumUp(&sums.aside);
  return sums;
}

// In the box around the corner of a place of the grid of displacements.
float VotesInBox(const std::vector<float>& sums, int column, int row, int width, int height) {
  const int left = column + kMargin - width / 2, right = left + width;
  const int bottom = row + kMargin - height / 2, top = bottom + height;
  return sums[Corner(right, top)] - sums[Corner(left, top)] - sums[Corner(right, bottom)] +
         sums[Corner(left, bottom)];
}

std::size_t Place(int column, int row) { return static_cast<std::size_t>(row * kPlaces + column); }

}  // namespace

VotingPoints MakeVotingPoints(const std::vector<Eigen::Vector2d>& points, std::size_t max_count) {
  struct Entry {
    std::uint64_t order;
    std::int64_t column, row;
    Eigen::Vector2d point;
  };
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    if (!(p.norm() < kFarthest)) continue;
    const auto column = static_cast<std::int64_t>(std::floor(p.x() / kSquare));
    const auto row = static_cast<std::int64_t>(std::floor(p.y() / kSquare));
    const std::uint64_t square = static_cast<std::uint64_t>(column) << 32U;
    entries.push_back({Random(square ^ static_cast<std::uint64_t>(row)).Bits(), column, row, p});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.order, a.column, a.row) < std::tie(b.order, b.column, b.row);
  });
  VotingPoints voting;
  std::vector<Eigen::Vector2d>& kept = voting.positions;
  for (std::size_t i = 0; i < entries.size() && kept.size() < max_count; ++i) {
    const bool is_same =
        i > 0 && entries[i].column == entries[i - 1].column && entries[i].row == entries[i - 1].row;
    if (!is_same) kept.push_back(entries[i].point);
  }
  for (const Eigen::Vector2d& p : kept) {
    const auto nearby = std::count_if(kept.begin(), kept.end(), [&p](const Eigen::Vector2d& q) {
      return (p - q).squaredNorm() < kNearby * kNearby;
    });
    voting.weights.push_back(1.0 / static_cast<double>(nearby));
  }
  return voting;
}

DisplacementVotes::DisplacementVotes() : votes_(Place(0, kPlaces), 0.0) {}

DisplacementVotes::DisplacementVotes(const VotingPoints& before,
                                     const VotingPoints& after,
                                     double max_turn)
    : DisplacementVotes() {
  const int num_steps = static_cast<int>(std::ceil(max_turn / kTurnStep));
  for (int step = -num_steps; step <= num_steps; ++step) {
    // p_before = R(turn) p_after + t; the chord half-way is R(-turn / 2) t.
    const double half_turn = 0.5 * kTurnStep * step;
    const VoteSums sums = CountVotes(Turned(before, -half_turn), Turned(after, half_turn));
    for (int row = 0; row < kPlaces; ++row) {
      for (int column = 0; column < kPlaces; ++column) {
        const double votes = VotesInBox(sums.ahead, column, row, kAlongCells, kAcrossCells) +
                             VotesInBox(sums.aside, column, row, kAcrossCells, kAlongCells);
        votes_[Place(column, row)] = std::max(votes_[Place(column, row)], votes);
      }
    }
  }
  UpdateMean();
}

double DisplacementVotes::At(const Eigen::Vector2d& displacement) const {
  const Eigen::Vector2d place = displacement / kCell + Eigen::Vector2d::Constant(kReachCells);
  if (!(place.minCoeff() > -0.5) || !(place.maxCoeff() < kPlaces - 0.5)) return Mean();
  return votes_[Place(static_cast<int>(std::lround(place.x())),
                      static_cast<int>(std::lround(place.y())))];
}

// Points meet over the width of the boxes: the middle of the top is looked for.
Eigen::Vector2d DisplacementVotes::Best() const {
  const auto most = std::max_element(votes_.begin(), votes_.end());
  const auto index = static_cast<int>(std::distance(votes_.begin(), most));
  const int best_column = index % kPlaces, best_row = index / kPlaces;
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  double sum = 0.0;
  for (int row = std::max(0, best_row - kTop); row <= std::min(kPlaces - 1, best_row + kTop);
       ++row) {
    for (int column = std::max(0, best_column - kTop);
         column <= std::min(kPlaces - 1, best_column + kTop);
         ++column) {
      const double weight = std::max(0.0, votes_[Place(column, row)] - kTopShare * *most);
      weighted += weight * Eigen::Vector2d(column - kReachCells, row - kReachCells);
      sum += weight;
    }
  }
  return sum > 0.0 ? Eigen::Vector2d(kCell / sum * weighted) : Eigen::Vector2d(0.0, 0.0);
}

void DisplacementVotes::UpdateMean() {
  mean_ = std::accumulate(votes_.begin(), votes_.end(), 0.0) / static_cast<double>(votes_.size());
}

void DisplacementVotes::Fade(double keep, const DisplacementVotes& other) {
  for (std::size_t i = 0; i < votes_.size(); ++i) votes_[i] = keep * votes_[i] + other.votes_[i];
  UpdateMean();
}

}  // namespace radive
