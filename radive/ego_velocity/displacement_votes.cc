// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/displacement_votes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "radive/ego_velocity/spread_points.h"
#include "radive/kernels/kernels.h"

namespace radive {
namespace {

constexpr double kCell = 0.25;      // of the grid of displacements [m]
constexpr double kTurnStep = 0.02;  // [rad]

constexpr int kReachCells = static_cast<int>(DisplacementVotes::kReach / kCell);
constexpr int kPlaces = 2 * kReachCells + 1;  // displacements along an axis

// The top around the most votes [cells to each side, share of them].
constexpr int kTop = 6;
constexpr double kTopShare = 0.85;

constexpr double kNearby = 2.0;  // neighbours share their weight [m]

// Of kPlaces and VoteGrids: the reach, and half a box to each side.
static_assert(kPlaces == VoteGrids::kPlaces);
constexpr double kCounted = 0.5 * VoteGrids::kCells * kCell;

// Points of a scan that are turned, in cells. Those before are in bins along x, so that few of them
// are looked at for a point after.
class TurnedPoints {
 public:
  explicit TurnedPoints(const VotingPoints& points)
      : points_(points),
        turned_(points.positions.size()),
        columns_(3 * (points.positions.size() + kSpare)) {}

  void Turn(double angle) {
    const double cosine = std::cos(angle) / kCell, sine = std::sin(angle) / kCell;
    for (std::size_t i = 0; i < turned_.size(); ++i) {
      const Eigen::Vector2d& p = points_.positions[i];
      turned_[i] = {static_cast<float>(cosine * p.x() - sine * p.y()),
                    static_cast<float>(sine * p.x() + cosine * p.y())};
    }
  }

  void SortIntoBins() {
    begins_.fill(0);
    for (const Eigen::Vector2f& p : turned_) ++begins_[BinOf(p.x()) + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::array<int, kNumBins + 1> next = begins_;
    float* x = columns_.data();
    float* y = x + turned_.size() + kSpare;
    float* weight = y + turned_.size() + kSpare;
    for (std::size_t i = 0; i < turned_.size(); ++i) {
      const int row = next[BinOf(turned_[i].x())]++;
      x[row] = turned_[i].x();
      y[row] = turned_[i].y();
      weight[row] = static_cast<float>(points_.weights[i]);
    }
  }

  // Adds the votes of the points `after` with these.
  void Vote(const TurnedPoints& after, const VoteGrids& grids) const {
    const float* x = columns_.data();
    const float* y = x + turned_.size() + kSpare;
    const VoteColumns columns = {x, y, y + turned_.size() + kSpare};
    constexpr float kHalf = 0.5F * VoteGrids::kCells;
    const Kernels& kernels = ActiveKernels();
    for (std::size_t i = 0; i < after.turned_.size(); ++i) {
      const Eigen::Vector2f& p = after.turned_[i];
      kernels.add_votes(columns,
                        begins_[BinOf(p.x() - kHalf)],
                        begins_[BinOf(p.x() + kHalf) + 1],
                        p.x() - kHalf,
                        p.y() - kHalf,
                        static_cast<float>(after.points_.weights[i]),
                        std::abs(p.x()) > std::abs(p.y()) ? grids.ahead : grids.aside);
    }
  }

 private:
  static constexpr std::size_t kSpare = 7;  // see VoteColumns
  static constexpr std::size_t kNumBins = 160;
  static constexpr float kBin =
      static_cast<float>(2.0 * kFarthestPoint / kCell / kNumBins);  // [cells]

  // What lies outside is in the first or last one.
  static std::size_t BinOf(float x) {
    const float bin = std::floor(x / kBin) + 0.5F * kNumBins;
    return static_cast<std::size_t>(std::clamp(bin, 0.0F, static_cast<float>(kNumBins - 1)));
  }

  const VotingPoints& points_;
  std::vector<Eigen::Vector2f> turned_;        // [cells]
  std::vector<float> columns_;                 // x, y and weight, by bins
  std::array<int, kNumBins + 1> begins_ = {};  // of the bins
};

std::size_t Place(int column, int row) { return static_cast<std::size_t>(row * kPlaces + column); }

// How many of the points are nearby each, itself included.
std::vector<int> CountNearby(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::size_t> by_x(points.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&points](std::size_t a, std::size_t b) {
    return points[a].x() < points[b].x();
  });
  std::vector<int> counts(points.size(), 1);
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Eigen::Vector2d& p = points[by_x[i]];
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      const Eigen::Vector2d difference = points[by_x[j]] - p;
      if (!(difference.x() < kNearby)) break;
      if (difference.squaredNorm() >= kNearby * kNearby) continue;
      ++counts[by_x[i]];
      ++counts[by_x[j]];
    }
  }
  return counts;
}

}  // namespace

VotingPoints MakeVotingPoints(const std::vector<Eigen::Vector2d>& points, std::size_t max_count) {
  VotingPoints voting;
  for (const std::size_t index : SpreadOut(points, max_count)) {
    voting.positions.push_back(points[index]);
  }
  for (const int nearby : CountNearby(voting.positions)) voting.weights.push_back(1.0 / nearby);
  return voting;
}

DisplacementVotes::DisplacementVotes() : votes_(Place(0, kPlaces), 0.0) {}

DisplacementVotes::DisplacementVotes(const VotingPoints& before,
                                     const VotingPoints& after,
                                     double max_turn)
    : DisplacementVotes() {
  std::vector<float> ahead(VoteGrids::kSize), aside(VoteGrids::kSize);
  std::vector<float> most(VoteGrids::kStride * kPlaces);
  const VoteGrids grids = {ahead.data(), aside.data()};
  TurnedPoints turned_before(before), turned_after(after);
  const int num_steps = static_cast<int>(std::ceil(max_turn / kTurnStep));
  for (int step = -num_steps; step <= num_steps; ++step) {
    // p_before = R(turn) p_after + t; the chord half-way is R(-turn / 2) t.
    const double half_turn = 0.5 * kTurnStep * step;
    turned_before.Turn(-half_turn);
    turned_before.SortIntoBins();
    turned_after.Turn(half_turn);
    turned_before.Vote(turned_after, grids);
    ActiveKernels().raise_to_boxes(grids, most.data());
  }
  for (int row = 0; row < kPlaces; ++row) {
    for (int column = 0; column < kPlaces; ++column) {
      votes_[Place(column, row)] =
          most[static_cast<std::size_t>(row * VoteGrids::kStride + column)];
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
