// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/box_association.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <utility>

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

// Adds one row after the other, each along the shortest path of reassignments. A path may also end
// with a row that gives up its column, as if each row had a column of its own at length kMissed.
class Assigner {
 public:
  explicit Assigner(const Eigen::MatrixXd& cost)
      : cost_(cost),
        column_of_row_(cost.rows(), kNone),
        row_of_column_(cost.cols(), kNone),
        row_potential_(cost.rows()),
        column_potential_(cost.cols()) {}

  std::vector<int> Solve() {
    for (int row = 0; row < Rows(); ++row) AddRow(row);
    tie_ = kTieFraction * LargestCost();
    for (int row = 0; row < Rows(); ++row) LowerColumn(row);
    return column_of_row_;
  }

 private:
  int Rows() const { return static_cast<int>(column_of_row_.size()); }
  int Columns() const { return static_cast<int>(row_of_column_.size()); }

  double LargestCost() const {
    double largest = 0.0;
    for (const double cost : cost_.reshaped()) {
      if (cost != kForbidden) largest = std::max(largest, std::abs(cost));
    }
    return largest;
  }

  Length Reduced(int row, int column) const {
    return Length{0.0, cost_(row, column)} - row_potential_[row] - column_potential_[column];
  }

  // Tree of the shortest paths from a new row.
  struct Tree {
    std::vector<Length> distance;  // by column
    std::vector<int> from;         // by column: the row before it
    std::vector<int> settled;      // columns, in order of distance
    std::vector<bool> is_settled;
    Length missed = kUnreached;  // of the shortest path that leaves a row without a column
    int missed_row = kNone;
  };

  void Relax(int row, const Length& distance, Tree& tree) const {
    for (int column = 0; column < Columns(); ++column) {
      if (tree.is_settled[column] || cost_(row, column) == kForbidden) continue;
      const Length through = distance + Reduced(row, column);
      if (through < tree.distance[column]) {
        tree.distance[column] = through;
        tree.from[column] = row;
      }
    }
    const Length missed = distance + kMissed - row_potential_[row];
    if (missed < tree.missed) {
      tree.missed = missed;
      tree.missed_row = row;
    }
  }

  static int Nearest(const Tree& tree) {
    int nearest = kNone;
    for (int column = 0; column < static_cast<int>(tree.distance.size()); ++column) {
      if (tree.is_settled[column] || tree.distance[column] == kUnreached) continue;
      if (nearest == kNone || tree.distance[column] < tree.distance[nearest]) nearest = column;
    }
    return nearest;
  }

  void AddRow(int start) {
    Tree tree{std::vector<Length>(Columns(), kUnreached),
              std::vector<int>(Columns(), kNone),
              {},
              std::vector<bool>(Columns(), false)};
    Relax(start, {}, tree);
    int end = kNone;
    Length length;
    while (true) {
      end = Nearest(tree);
      if (end == kNone || tree.missed < tree.distance[end]) end = kNone;
      length = end == kNone ? tree.missed : tree.distance[end];
      if (end == kNone || row_of_column_[end] == kNone) break;
      tree.is_settled[end] = true;
      tree.settled.push_back(end);
      Relax(row_of_column_[end], tree.distance[end], tree);
    }
    row_potential_[start] = row_potential_[start] + length;
    for (const int column : tree.settled) {
      const Length rest = length - tree.distance[column];
      Length& row_potential = row_potential_[row_of_column_[column]];
      row_potential = row_potential + rest;
      column_potential_[column] = column_potential_[column] - rest;
    }
    Reassign(end, tree);
  }

  // Reassigns all rows on the path to `end`. The new row had no column.
  void Reassign(int end, const Tree& tree) {
    int row = tree.missed_row;
    if (end == kNone) end = std::exchange(column_of_row_[row], kNone);
    while (end != kNone) {
      row = tree.from[end];
      row_of_column_[end] = row;
      end = std::exchange(column_of_row_[row], end);
    }
  }

  bool IsTie(const Length& reduced) const {
    return reduced.missed == 0.0 && std::abs(reduced.cost) <= tie_;
  }
  bool IsTight(int row, int column) const {
    return cost_(row, column) != kForbidden && IsTie(Reduced(row, column));
  }

  // The columns that `row` can take without changing the total, if rows after it may move. The
  // search runs backwards from the column that `row` gives up. kNone stands for everything without
  // a partner. A row may move there at length 0 if another row fills the gap (`filler`) or the
  // column given up can stay without a row.
  struct Moves {
    std::vector<bool> is_available;  // by column
    std::vector<int> next;           // by row: the column it moves to
    std::vector<int> open;           // columns and kNone, in the order found
    bool is_none_available = false;
    int filler = kNone;  // row that fills a gap left by a move to kNone ...
    int filled = kNone;  // ... by moving to this column
  };

  static void MakeAvailable(int column, Moves& moves) {
    if (column == kNone) moves.is_none_available = true;
    if (column != kNone) moves.is_available[column] = true;
    moves.open.push_back(column);
  }

  void SearchFromNone(int row, Moves& moves) const {
    for (int column = 0; column < Columns(); ++column) {
      const int owner = row_of_column_[column];
      if (moves.is_available[column]) continue;
      if (owner == kNone || (owner > row && IsTie(kMissed - row_potential_[owner]))) {
        MakeAvailable(column, moves);
      }
    }
  }

  void SearchFromColumn(int row, int column, Moves& moves) const {
    for (int other = row + 1; other < Rows(); ++other) {
      const int left = column_of_row_[other];
      if (left == column || !IsTight(other, column)) continue;
      const bool is_spared = left == kNone || IsTie(column_potential_[left]);
      if (is_spared && !moves.is_none_available) {
        moves.filler = other;
        moves.filled = column;
        MakeAvailable(kNone, moves);
      }
      if (left == kNone || moves.is_available[left]) continue;
      moves.next[other] = column;
      MakeAvailable(left, moves);
    }
  }

  Moves FindMoves(int row) const {
    Moves moves{std::vector<bool>(Columns(), false), std::vector<int>(Rows(), kNone), {}};
    const int old = column_of_row_[row];
    if (old != kNone) MakeAvailable(old, moves);
    if (old == kNone || IsTie(column_potential_[old])) MakeAvailable(kNone, moves);
    for (std::size_t i = 0; i < moves.open.size(); ++i) {
      const int column = moves.open[i];
      if (column == kNone) SearchFromNone(row, moves);
      if (column != kNone) SearchFromColumn(row, column, moves);
    }
    return moves;
  }

  void Move(int row, int column, const Moves& moves) {
    while (row != kNone) {
      column_of_row_[row] = column;
      if (column == kNone) return;
      row = std::exchange(row_of_column_[column], row);
      if (row != kNone) column = moves.next[row];
    }
  }

  void Leave(int column) {
    if (column != kNone) row_of_column_[column] = kNone;
  }

  // Moves `row` to the lowest column that does not increase the total, without changing the rows
  // before it.
  void LowerColumn(int row) {
    const int old = column_of_row_[row];
    const Moves moves = FindMoves(row);
    const int end = old == kNone ? Columns() : old;
    int column = 0;
    while (column < end && !(moves.is_available[column] && IsTight(row, column))) ++column;
    if (column == end) return;
    Leave(old);
    Move(row, column, moves);
    if (old == kNone || row_of_column_[old] != kNone || moves.filler == kNone) return;
    Leave(column_of_row_[moves.filler]);
    Move(moves.filler, moves.filled, moves);
  }

  const Eigen::MatrixXd& cost_;
  std::vector<int> column_of_row_;
  std::vector<int> row_of_column_;
  std::vector<Length> row_potential_;     // length of a pair >= the sum of its two potentials,
  std::vector<Length> column_potential_;  // equal where assigned; 0 for a free column
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
BoxSums SumWeights(std::span<const BoxMember> cluster, std::span<const ImageBox> boxes,
                   Weight weight) {
  BoxSums sums{std::vector<double>(boxes.size(), 0.0)};
  for (const BoxMember& member : cluster) {
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

BoxProbabilities BoundedBoxWeights::Compute(std::span<const BoxMember> cluster,
                                            std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(cluster, boxes, [](const BoxMember& member) {
    return std::sqrt(member.measurement_determinant / member.innovation_determinant);
  });
  return Normalize(sums, sums.in_none);
}

BoxProbabilities BoxWeightsLiteral::Compute(std::span<const BoxMember> cluster,
                                            std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(
      cluster, boxes, [](const BoxMember& member) { return 1.0 / member.position_determinant; });
  return Normalize(sums, 0.0);
}

double SharedBoxCost::Cost(double p, double share) { return -std::log(p) - std::log(share); }

double UnsharedBoxCost::Cost(double p, double) { return -std::log(p); }

std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options, BoxCostFunction cost) {
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
