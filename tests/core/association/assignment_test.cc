// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/support/error_message.h"

namespace cvo::assignment_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Total {
  int pairs = 0;
  double cost = 0.0;
};

Total Sum(const Eigen::MatrixXd& cost, const std::vector<int>& columns) {
  Total total;
  for (int row = 0; row < cost.rows(); ++row) {
    if (columns[row] < 0) continue;
    ++total.pairs;
    total.cost += cost(row, columns[row]);
  }
  return total;
}

// Tries all assignments, in the order in which ties must be broken.
class BruteForce {
 public:
  explicit BruteForce(const Eigen::MatrixXd& cost) : cost_(cost), columns_(cost.rows(), -1) {}

  std::vector<int> Solve() {
    Try(0);
    return best_;
  }

 private:
  void Try(int row) {
    if (row == cost_.rows()) {
      const Total total = Sum(cost_, columns_);
      const Total best = best_.empty() ? Total{-1, 0.0} : Sum(cost_, best_);
      if (total.pairs > best.pairs || (total.pairs == best.pairs && total.cost < best.cost)) {
        best_ = columns_;
      }
      return;
    }
    for (int column = 0; column < cost_.cols(); ++column) {
      if (cost_(row, column) == kInfinity) continue;
      if (std::find(columns_.begin(), columns_.begin() + row, column) != columns_.begin() + row) {
        continue;
      }
      columns_[row] = column;
      Try(row + 1);
    }
    columns_[row] = -1;
    Try(row + 1);
  }

  const Eigen::MatrixXd& cost_;
  std::vector<int> columns_;
  std::vector<int> best_;
};

TEST(Assign, HandComputed) {
  Eigen::MatrixXd cost(3, 3);
  cost << 4, 1, 3,  //
      2, 0, 5,      //
      3, 2, 2;
  EXPECT_EQ(Assign(cost), (std::vector<int>{1, 0, 2}));
  EXPECT_EQ(Assign(-cost), (std::vector<int>{0, 2, 1}));
}

// Costs are integers of few distinct values, so there are many ties. Assign must break them as the
// brute force does.
TEST(Assign, ReturnsTheFirstOfTheBestAssignments) {
  Rng rng(1, "assign");
  for (int trial = 0; trial < 3000; ++trial) {
    const int values = 1 + static_cast<int>(rng.UniformInt(6));
    const double forbidden = rng.Uniform() < 0.5 ? 0.0 : rng.Uniform();
    Eigen::MatrixXd cost(1 + rng.UniformInt(5), 1 + rng.UniformInt(5));
    for (double& value : cost.reshaped()) {
      value = static_cast<double>(rng.UniformInt(values)) - 2.0;
      if (rng.Uniform() < forbidden) value = kInfinity;
    }
    ASSERT_EQ(Assign(cost), BruteForce(cost).Solve()) << cost;
  }
}

TEST(Assign, AgreesWithBruteForceForRealCosts) {
  Rng rng(2, "assign");
  for (int trial = 0; trial < 300; ++trial) {
    Eigen::MatrixXd cost(1 + rng.UniformInt(6), 1 + rng.UniformInt(6));
    for (double& value : cost.reshaped()) value = rng.Uniform() < 0.2 ? kInfinity : rng.Normal();
    ASSERT_EQ(Assign(cost), BruteForce(cost).Solve()) << cost;
  }
}

TEST(Assign, PrefersMorePairsAtAnyCost) {
  Eigen::MatrixXd cost(2, 2);
  cost << -1e9, 1e9,  //
      -1e9, kInfinity;
  EXPECT_EQ(Assign(cost), (std::vector<int>{1, 0}));
}

// The last bit of a sum of thirds depends on the order of its terms, which must not decide.
TEST(Assign, RoundingDoesNotBreakTies) {
  const double third = 1.0 / 3.0;
  Eigen::MatrixXd cost(3, 3);
  cost << third, 2 * third, third,  //
      third, 0.1 + 0.2, third,      //
      third, 0.3, third;
  EXPECT_EQ(Assign(cost), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(Assign(Eigen::MatrixXd::Constant(40, 40, third))[39], 39);
}

TEST(Assign, ManyRows) {
  Rng rng(3, "assign");
  Eigen::MatrixXd cost(120, 200);
  for (double& value : cost.reshaped()) value = rng.Uniform(1.0, 2.0);
  for (int row = 0; row < 120; ++row) cost(row, (7 * row + 3) % 200) = 0.5;
  const std::vector<int> columns = Assign(cost);
  for (int row = 0; row < 120; ++row) EXPECT_EQ(columns[row], (7 * row + 3) % 200);
  const std::vector<int> transposed = Assign(cost.transpose());
  for (int row = 0; row < 120; ++row) EXPECT_EQ(transposed[(7 * row + 3) % 200], row);
  EXPECT_EQ(std::count(transposed.begin(), transposed.end(), -1), 80);
}

TEST(Assign, NothingToAssign) {
  EXPECT_TRUE(Assign(Eigen::MatrixXd(0, 0)).empty());
  EXPECT_TRUE(Assign(Eigen::MatrixXd(0, 3)).empty());
  EXPECT_EQ(Assign(Eigen::MatrixXd(2, 0)), (std::vector<int>{-1, -1}));
  EXPECT_EQ(Assign(Eigen::MatrixXd::Constant(2, 3, kInfinity)), (std::vector<int>{-1, -1}));
}

TEST(Assign, RefusesNanAndMinusInfinity) {
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(2, 2);
  cost(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ErrorMessage([&] { Assign(cost); }), "");
  cost(1, 0) = -kInfinity;
  EXPECT_NE(ErrorMessage([&] { Assign(cost); }), "");
}

}  // namespace
}  // namespace cvo::assignment_test
