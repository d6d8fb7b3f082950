// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/box_association.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>

#include "core/base/error.h"

namespace cvo {

namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();
constexpr double kTieFraction = 1e-12;
constexpr int kNone = -1;

// Number of missed pairs, then cost, in lexicographic order. Shortest paths need only an order and
// sums, so no large constant has to stand for a missed pair.
struct Length {
  double missed = 0.0;
  double cost = 0.0;

  friend Length operator+(const Length& a, const Length& b) {
    return {a.missed + b.missed, a.cost + b.cost};
  }
  friend Length operator-(const Length& a, const Length& b) {
    return {a.missed - b.missed, a.cost - b.cost};
  }
  friend auto operator<=>(const Length&, const Length&) = default;
};

constexpr Length kMissed{1.0, 0.0};
constexpr Length kUnreached{kForbidden, 0.0};

// Adds one row after the other, each along the shortest path of reassignments. So that every row
// and every column always has a partner, each row has a column of its own for being missed, and
// each column a row of its own for being left.
class Assigner {
 public:
  explicit Assigner(const Eigen::MatrixXd& cost)
      : cost_(cost),
        rows_(static_cast<int>(cost.rows())),
        columns_(static_cast<int>(cost.cols())),
        size_(rows_ + columns_),
        column_of_row_(size_, kNone),
        row_of_column_(size_, kNone),
        row_potential_(size_),
        column_potential_(size_) {
    for (int column = 0; column < columns_; ++column) Pair(rows_ + column, column);
  }

  std::vector<int> Solve() {
    for (int row = 0; row < rows_; ++row) AddRow(row);
    for (const double cost : cost_.reshaped()) {
      if (cost != kForbidden) tie_ = std::max(tie_, kTieFraction * std::abs(cost));
    }
    for (int row = 0; row < rows_; ++row) LowerColumn(row);
    column_of_row_.resize(rows_);
    for (int& column : column_of_row_) column = column < columns_ ? column : kNone;
    return column_of_row_;
  }

 private:
  void Pair(int row, int column) {
    column_of_row_[row] = column;
    row_of_column_[column] = row;
  }

  Length LengthOf(int row, int column) const {
    if (row < rows_ && column < columns_) {
      return cost_(row, column) == kForbidden ? kUnreached : Length{0.0, cost_(row, column)};
    }
    if (row < rows_) return column == columns_ + row ? kMissed : kUnreached;
    return column >= columns_ || row == rows_ + column ? Length{} : kUnreached;
  }

  Length Reduced(int row, int column) const {
    return LengthOf(row, column) - row_potential_[row] - column_potential_[column];
  }

  void AddRow(int start) {
    std::vector<Length> distance(size_, kUnreached);
    std::vector<int> from(size_, kNone);  // by column: the row before it
    std::vector<bool> is_settled(size_, false);
    std::vector<int> settled;  // columns, in order of distance
    Length length;
    int end = kNone;
    for (int row = start; row != kNone; row = row_of_column_[end]) {
      if (end != kNone) settled.push_back(end);
      if (end != kNone) is_settled[end] = true;
      end = kNone;
      for (int column = 0; column < size_; ++column) {
        if (is_settled[column]) continue;
        const Length through = length + Reduced(row, column);
        if (through < distance[column]) {
          distance[column] = through;
          from[column] = row;
        }
        if (end == kNone || distance[column] < distance[end]) end = column;
      }
      length = distance[end];
    }
    row_potential_[start] = row_potential_[start] + length;
    for (const int column : settled) {
      const Length rest = length - distance[column];
      Length& row_potential = row_potential_[row_of_column_[column]];
      row_potential = row_potential + rest;
      column_potential_[column] = column_potential_[column] - rest;
    }
    while (end != kNone) {
      const int row = from[end];
      const int left = column_of_row_[row];
      Pair(row, end);
      end = left;
    }
  }

  bool IsTie(int row, int column) const {
    const Length reduced = Reduced(row, column);
    return reduced.missed == 0.0 && std::abs(reduced.cost) <= tie_;
  }

  // Moves `row`, and others after row `fixed`, without changing the total, such that `gap` gets a
  // row. False if there is no way without the columns `visited`.
  bool MoveTo(int gap, int row, int fixed, std::vector<bool>& visited) {
    for (int column = 0; row > fixed && column < size_; ++column) {
      if (visited[column] || !IsTie(row, column)) continue;
      visited[column] = true;
      if (column != gap && !MoveTo(gap, row_of_column_[column], fixed, visited)) continue;
      Pair(row, column);
      return true;
    }
    return false;
  }

  // Moves `row` to the lowest column that does not increase the total, without changing the rows
  // before it.
  void LowerColumn(int row) {
    const int old = column_of_row_[row];
    for (int column = 0; column < std::min(old, columns_); ++column) {
      if (!IsTie(row, column)) continue;
      std::vector<bool> visited(size_, false);
      visited[column] = true;
      if (!MoveTo(old, row_of_column_[column], row, visited)) continue;
      Pair(row, column);
      return;
    }
  }

  const Eigen::MatrixXd& cost_;
  int rows_;
  int columns_;
  int size_;
  std::vector<int> column_of_row_;
  std::vector<int> row_of_column_;
  std::vector<Length> row_potential_;     // length of a pair >= the sum of its two potentials,
  std::vector<Length> column_potential_;  // equal where assigned
  double tie_ = 0.0;
};

}  // namespace

std::vector<int> Assign(const Eigen::MatrixXd& cost) {
  for (const double value : cost.reshaped()) {
    if (!(value > -kForbidden)) {
      ThrowError("Assign", StrCat("a cost of ", value), "finite costs, or infinity to forbid");
    }
  }
  return Assigner(cost).Solve();
}

namespace {

// Weight of the members in each box, and of those in no box.
struct BoxSums {
  std::vector<double> by_box;
  double in_none = 0.0;
};

template <typename Weight>
BoxSums SumWeights(std::span<const PredictedLandmark> cluster, std::span<const ImageBox> boxes,
                   Weight weight) {
  BoxSums sums{std::vector<double>(boxes.size(), 0.0)};
  for (const PredictedLandmark& member : cluster) {
    const double w = weight(member);
    bool in_any = false;
    for (std::size_t m = 0; m < boxes.size(); ++m) {
      if (!boxes[m].Contains(member.zeta_px[0], member.zeta_px[1])) continue;
      sums.by_box[m] += w;
      in_any = true;
    }
    if (!in_any) sums.in_none += w;
  }
  return sums;
}

double Information(double p) { return p > 0.0 ? -p * std::log(p) : 0.0; }

// Computes the probabilities and their entropy. `in_none` is the weight of the null box.
BoxProbabilities Normalize(const BoxSums& sums, double in_none) {
  BoxProbabilities result{sums.by_box, sums.by_box, 0.0};
  double total = in_none;
  for (const double weight : sums.by_box) total += weight;
  if (!(total > 0.0)) return result;
  for (double& p : result.probability) {
    p /= total;
    result.entropy += Information(p);
  }
  result.entropy += Information(in_none / total);
  result.entropy /= std::log(2.0);
  return result;
}

}  // namespace

BoxProbabilities BoundedBoxes::Compute(std::span<const PredictedLandmark> cluster,
                                       std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(cluster, boxes, [](const PredictedLandmark& member) {
    return std::sqrt(member.measurement_px2.determinant() / member.innovation_px2.determinant());
  });
  return Normalize(sums, sums.in_none);
}

BoxProbabilities PrintedBoxWeights::Compute(std::span<const PredictedLandmark> cluster,
                                            std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(cluster, boxes, [](const PredictedLandmark& member) {
    return 1.0 / member.position_px2.determinant();
  });
  return Normalize(sums, 0.0);
}

double BoundedBoxes::Cost(double p, double share) { return -std::log(p) - std::log(share); }

double PrintedBoxWeights::Cost(double p, double) { return -std::log(p); }

std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options,
                                double (*cost)(double p, double share)) {
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(clusters.size()),
                                                    boxes, std::numeric_limits<double>::infinity());
  std::vector<double> total(static_cast<std::size_t>(boxes), 0.0);
  for (const BoxProbabilities& cluster : clusters) {
    for (int m = 0; m < boxes; ++m) total[m] += cluster.weight[m];
  }
  for (std::size_t q = 0; q < clusters.size(); ++q) {
    if (!(clusters[q].entropy < options.max_entropy)) continue;
    for (int m = 0; m < boxes; ++m) {
      const double p = clusters[q].probability[m];
      if (!(p > 0.0)) continue;
      costs(static_cast<Eigen::Index>(q), m) = cost(p, clusters[q].weight[m] / total[m]);
    }
  }
  return Assign(costs);
}

}  // namespace cvo
