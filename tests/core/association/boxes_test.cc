// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/support/error_message.h"

namespace cvo::boxes_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

const std::vector<ImageBox> kTwoBoxes = {{0, 0, 100, 100}, {200, 0, 300, 100}};

// A landmark at (u_px, v_px) whose weight is `weight`, for both kinds of weights.
PredictedLandmark At(double u_px, double v_px, double weight = 1.0) {
  PredictedLandmark member;
  member.zeta_px = {u_px, v_px, 0.0};
  member.measurement_px2(0, 0) = weight * weight;
  member.position_px2(0, 0) = 1.0 / weight;
  return member;
}

std::vector<PredictedLandmark> Several(int count, double u_px, double v_px) {
  return std::vector<PredictedLandmark>(static_cast<std::size_t>(count), At(u_px, v_px));
}

std::vector<PredictedLandmark> Join(std::vector<PredictedLandmark> a,
                                    const std::vector<PredictedLandmark>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(BoundedBoxes, HandComputed) {
  // Two landmarks in the first box, one in the second and one in neither have weights of 1.5, 0.25
  // and 0.25, in total 2.
  const std::vector<PredictedLandmark> cluster = {At(50, 50), At(60, 10, 0.5), At(250, 50, 0.25),
                                                  At(150, 50, 0.25)};
  const BoxProbabilities p = BoundedBoxes::Compute(cluster, kTwoBoxes);
  EXPECT_DOUBLE_EQ(p.probability[0], 0.75);
  EXPECT_DOUBLE_EQ(p.probability[1], 0.125);
  EXPECT_DOUBLE_EQ(p.weight[0], 1.5);
  EXPECT_DOUBLE_EQ(p.weight[1], 0.25);
  // 3/4 log2(4/3) + 2 * 1/8 * 3 bits, including the null box.
  EXPECT_NEAR(p.entropy, 0.75 * std::log2(4.0 / 3.0) + 0.75, 1e-12);
}

TEST(PrintedBoxWeights, HandComputed) {
  // Two landmarks of weight 1/4 in the first box, one of weight 1/2 in the second. Landmarks in no
  // box do not count.
  const std::vector<PredictedLandmark> cluster = {At(50, 50, 0.25), At(60, 10, 0.25),
                                                  At(250, 50, 0.5), At(150, 50, 8.0)};
  const BoxProbabilities p = PrintedBoxWeights::Compute(cluster, kTwoBoxes);
  EXPECT_DOUBLE_EQ(p.probability[0], 0.5);
  EXPECT_DOUBLE_EQ(p.probability[1], 0.5);
  EXPECT_NEAR(p.entropy, 1.0, 1e-12);  // in bits, like the limit
}

// Returns the box of each cluster, using BoundedBoxes.
std::vector<int> Associate(const std::vector<std::vector<PredictedLandmark>>& clusters,
                           const std::vector<ImageBox>& boxes) {
  std::vector<BoxProbabilities> probabilities;
  for (const auto& cluster : clusters) {
    probabilities.push_back(BoundedBoxes::Compute(cluster, boxes));
  }
  return AssociateBoxes(probabilities, static_cast<int>(boxes.size()), {}, &BoundedBoxes::Cost);
}

TEST(AssociateBoxes, EachClusterGetsItsBoxInAnyOrder) {
  const auto left = Several(10, 50, 50);
  const auto right = Several(10, 250, 50);
  EXPECT_THAT(Associate({left, right}, kTwoBoxes), ElementsAre(0, 1));
  EXPECT_THAT(Associate({right, left}, kTwoBoxes), ElementsAre(1, 0));
  EXPECT_THAT(Associate({left, right}, {kTwoBoxes[1]}), ElementsAre(-1, 0));
}

TEST(AssociateBoxes, DistinguishesOverlappingBoxesByLandmarksInOneOfThem) {
  const std::vector<ImageBox> boxes = {{0, 0, 100, 100}, {40, 0, 160, 100}};
  EXPECT_THAT(Associate({Join(Several(10, 50, 50), Several(2, 20, 50))}, boxes), ElementsAre(0));
  EXPECT_THAT(Associate({Join(Several(10, 50, 50), Several(2, 150, 50))}, boxes), ElementsAre(1));
  // Two bodies, one in front of the other.
  EXPECT_THAT(Associate({Join(Several(6, 50, 50), Several(6, 20, 50)),
                         Join(Several(6, 60, 50), Several(6, 150, 50))},
                        boxes),
              ElementsAre(0, 1));
}

// A ghost has few landmarks, all of them in the box of a body that has many, most of them in it.
TEST(AssociateBoxes, OnlyTheCostOfSharesKeepsABoxFromAGhost) {
  const std::vector<ImageBox> boxes = {kTwoBoxes[0]};
  const std::vector<BoxProbabilities> clusters = {
      BoundedBoxes::Compute(Several(4, 50, 50), boxes),
      BoundedBoxes::Compute(Join(Several(20, 60, 60), Several(2, 150, 50)), boxes)};
  EXPECT_THAT(AssociateBoxes(clusters, 1, {}, &BoundedBoxes::Cost), ElementsAre(-1, 0));
  EXPECT_THAT(AssociateBoxes(clusters, 1, {}, &PrintedBoxWeights::Cost), ElementsAre(0, -1));
}

TEST(AssociateBoxes, RefusesAClusterSpreadOverBoxes) {
  const std::vector<ImageBox> boxes = {{0, 0, 10, 10}, {20, 0, 30, 10}, {40, 0, 50, 10}};
  const auto spread =
      Join(Several(12, 5, 5), Join(Several(10, 25, 5), Several(10, 45, 5)));  // 1.58 bits
  const BoxProbabilities p = BoundedBoxes::Compute(spread, boxes);
  ClusterAssociationOptions options;
  options.max_entropy = 1.5;
  EXPECT_THAT(AssociateBoxes({&p, 1}, 3, options, &BoundedBoxes::Cost), ElementsAre(-1));
  options.max_entropy = 1.6;
  EXPECT_THAT(AssociateBoxes({&p, 1}, 3, options, &BoundedBoxes::Cost), ElementsAre(0));
}

TEST(AssociateBoxes, HandlesNoClustersAndNoBoxes) {
  EXPECT_THAT(Associate({}, kTwoBoxes), IsEmpty());
  EXPECT_THAT(Associate({Several(5, 50, 50), {}}, {}), ElementsAre(-1, -1));
  EXPECT_THAT(Associate({{}, Several(5, 50, 50)}, kTwoBoxes), ElementsAre(-1, 0));
}

TEST(ImageBox, ContainsItsEdges) {
  const ImageBox box{10, 20, 30, 40};
  EXPECT_TRUE(box.Contains(10, 20));
  EXPECT_TRUE(box.Contains(30, 40));
  EXPECT_FALSE(box.Contains(9.99, 30));
  EXPECT_FALSE(box.Contains(20, 40.01));
  EXPECT_FALSE(box.Contains(std::nan(""), 30));
}

TEST(ImageBox, ShrinksAndGrowsAboutItsCentre) {
  const ImageBox box{10, 20, 30, 60};
  const ImageBox smaller = box.Shrunk(0.1);
  EXPECT_DOUBLE_EQ(smaller.left_px, 12.0);
  EXPECT_DOUBLE_EQ(smaller.top_px, 24.0);
  EXPECT_DOUBLE_EQ(smaller.right_px, 28.0);
  EXPECT_DOUBLE_EQ(smaller.bottom_px, 56.0);
  const ImageBox larger = box.Shrunk(-0.5);
  EXPECT_DOUBLE_EQ(larger.Width(), 40.0);
  EXPECT_DOUBLE_EQ(larger.Height(), 80.0);
}

TEST(IntersectionOverUnion, HandComputed) {
  const ImageBox box{0, 0, 10, 10};
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(box, box), 1.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(box, {5, 0, 15, 10}), 50.0 / 150.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({5, 5, 15, 15}, box), 25.0 / 175.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(box, {2, 2, 4, 7}), 0.1);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(box, {10, 0, 20, 10}), 0.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(box, {20, 20, 30, 30}), 0.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({5, 5, 5, 5}, {5, 5, 5, 5}), 0.0);
}

TEST(ShareInside, HandComputed) {
  const ImageBox box{0, 0, 10, 10};
  EXPECT_DOUBLE_EQ(ShareInside(box, box), 1.0);
  EXPECT_DOUBLE_EQ(ShareInside({2, 2, 4, 7}, box), 1.0);
  EXPECT_DOUBLE_EQ(ShareInside(box, {2, 2, 4, 7}), 0.1);
  EXPECT_DOUBLE_EQ(ShareInside({5, 5, 15, 15}, box), 0.25);
  EXPECT_DOUBLE_EQ(ShareInside({20, 20, 30, 30}, box), 0.0);
  EXPECT_DOUBLE_EQ(ShareInside({5, 5, 5, 5}, box), 0.0);
}

}  // namespace
}  // namespace cvo::boxes_test
