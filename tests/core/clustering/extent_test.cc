// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/rng.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/point_extent.h"
#include "tests/support/error_message.h"

namespace cvo::extent_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Eigen::Vector3d kCenter(3.0, -1.0, 12.0);

// Returns random points in a solid box with the given half sizes along the columns of `axes`.
Eigen::Matrix3Xd Solid(const Eigen::Vector3d& half_size_m, const Eigen::Matrix3d& axes, int count,
                       Rng& rng) {
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d unit(rng.Uniform(-1, 1), rng.Uniform(-1, 1), rng.Uniform(-1, 1));
    points.col(i) = kCenter + axes * half_size_m.cwiseProduct(unit);
  }
  return points;
}

Eigen::Matrix3d Turned() { return ExpSo3({0.3, 0.5, -0.2}).toRotationMatrix(); }

TEST(ExtentAlong, IsTwoFifthsOfTheHalfSizeOfASolid) {
  Rng rng(1, "extent");
  const Eigen::Vector3d half_size_m(2.0, 1.0, 0.5);
  const PointExtent extent = ExtentAlong(Turned(), Solid(half_size_m, Turned(), 20000, rng));
  EXPECT_TRUE(extent.half_size_m.isApprox(0.4 * half_size_m, 0.02)) << extent.half_size_m;
  EXPECT_LT((extent.center - kCenter).norm(), 0.04);
}

TEST(ExtentAlong, NeedsAPoint) {
  EXPECT_THAT(ErrorMessage([] { ExtentAlong(Eigen::Matrix3d::Identity(), {}); }),
              HasSubstr("no points"));
  EXPECT_THAT(ErrorMessage([] { PrincipalAxes({}); }), HasSubstr("no points"));
}

TEST(PrincipalAxes, AgreeWithTheAxesOfTheBody) {
  Rng rng(3, "extent");
  const RigidTransform frame = PrincipalAxes(Solid({2.0, 1.0, 0.5}, Turned(), 2000, rng));
  EXPECT_LT((frame.translation() - kCenter).norm(), 0.15);
  const Eigen::Matrix3d axes = frame.RotationMatrix();
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-9);
  const Eigen::Matrix3d cosines = (Turned().transpose() * axes).cwiseAbs();
  EXPECT_GT(cosines.diagonal().minCoeff(), std::cos(0.05));
  EXPECT_GT(axes.col(0).cwiseAbs().maxCoeff(), 0.0);
}

TEST(PrincipalAxes, DoNotDependOnPointOrderOrReflection) {
  Rng rng(4, "extent");
  const Eigen::Matrix3Xd points = Solid({2.0, 1.0, 0.5}, Turned(), 200, rng);
  const RigidTransform frame = PrincipalAxes(points);
  const RigidTransform reversed = PrincipalAxes(points.rowwise().reverse());
  EXPECT_LT(frame.Minus(reversed).norm(), 1e-9);
  // Point reflection preserves the axes of the body; the largest component of each is positive.
  const RigidTransform mirrored = PrincipalAxes(-points);
  EXPECT_TRUE(mirrored.RotationMatrix().isApprox(frame.RotationMatrix(), 1e-9));
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d direction = frame.RotationMatrix().col(axis);
    EXPECT_EQ(direction.maxCoeff(), direction.cwiseAbs().maxCoeff());
  }
}

TEST(PrincipalAxes, FallBackToTheCameraForAmbiguousShapes) {
  Rng rng(6, "extent");
  const auto angle = [](const Eigen::Matrix3Xd& points) {
    return RotationAngle(PrincipalAxes(points).rotation());
  };
  EXPECT_EQ(angle(Solid(Eigen::Vector3d::Ones(), Turned(), 500, rng)), 0.0);
  EXPECT_EQ(angle(Solid({2.0, 0.5, 0.5}, Turned(), 500, rng)), 0.0);
  EXPECT_EQ(angle(Solid({2.0, 0.0, 0.0}, Turned(), 500, rng)), 0.0);  // a line
  EXPECT_EQ(angle(kCenter), 0.0);
  EXPECT_EQ(angle(Eigen::Matrix3Xd(kCenter.replicate(1, 5))), 0.0);
}

std::vector<double> Spread(double from, double to, int count) {
  std::vector<double> depths;
  for (int i = 0; i < count; ++i) depths.push_back(from + (to - from) * (i + 0.5) / count);
  return depths;
}

std::vector<double> Joined(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<int> FirstIndices(int count) {
  std::vector<int> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

std::vector<int> Nearest(const std::vector<double>& depths_m, double angular_size) {
  const auto modes = DepthModes(depths_m, angular_size);
  return modes.empty() ? std::vector<int>() : modes.front();
}

constexpr double kCarAngle = 0.15;  // 3 m at 20 m

TEST(DepthModes, IgnoresAFewNearerPoints) {
  const std::vector<double> near = {5.0, 5.1, 5.2, 9.0, 14.0};
  std::vector<int> car = FirstIndices(20);
  EXPECT_EQ(Nearest(Joined(Joined(Spread(19, 21, 20), Spread(30, 40, 20)), near), kCarAngle), car);
}

TEST(DepthModes, ExtendFromTheirPeakNotFromAStrayPoint) {
  // Isolated points lie in front of the car and between the car and a wall.
  const std::vector<double> links = {17.9, 22, 23, 24, 25, 26, 27};
  const std::vector<double> depths = Joined(Joined(Spread(19, 21, 20), links), Spread(28, 29, 20));
  EXPECT_EQ(Nearest(depths, kCarAngle), FirstIndices(20));
}

TEST(DepthModes, WideBodiesMayBeDeep) {
  // A lorry that fills half the image is one body; at a smaller angular size, the same depths are
  // two bodies.
  const std::vector<double> depths = Joined(Spread(12, 15, 15), Spread(17.5, 21, 15));
  EXPECT_EQ(Nearest(depths, 0.7), FirstIndices(30));
  EXPECT_EQ(Nearest(depths, 0.1), FirstIndices(15));
}

TEST(DepthModes, IsEmptyWithTooFewPoints) {
  EXPECT_THAT(Nearest({}, kCarAngle), IsEmpty());
  EXPECT_THAT(Nearest(Spread(19, 21, 4), kCarAngle), IsEmpty());
  // Scattered points do not form a body.
  EXPECT_THAT(Nearest({1, 2, 4, 8, 16, 32, 64}, kCarAngle), IsEmpty());
}

// Depths with stereo noise, as of cars seen from behind and of furniture in front of a wall.
TEST(DepthModes, FindsTheForegroundInNoise) {
  Rng rng(8, "mode");
  for (const double z : {3.0, 8.0, 20.0, 40.0}) {
    double found = 0.0;
    double wrong = 0.0;
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<double> depths;
      for (int i = 0; i < 30; ++i) {
        const double depth = i < 15 ? z * rng.Uniform(0.95, 1.05) : z * rng.Uniform(1.35, 2.5);
        depths.push_back(350.0 / (350.0 / depth + 0.3 * rng.Normal()));
      }
      for (const int i : Nearest(depths, 0.12)) (i < 15 ? found : wrong) += 1.0;
    }
    EXPECT_GT(found / 1500.0, 0.9) << z;
    EXPECT_LT(wrong / found, 0.03) << z;
  }
}

constexpr ClusterId kNone{};

// A group of nodes with the same label and the same previous cluster.
struct Group {
  int count;
  int label;
  ClusterId previous;
};

// Labels: static scene, cluster 5, two new boxes, outliers.
std::vector<ClusterId> Match(std::initializer_list<Group> groups) {
  const CrfLabel labels[] = {{LabelKind::kStatic, kStaticScene},
                             {LabelKind::kCluster, ClusterId{5}},
                             {LabelKind::kNewBox, kNone},
                             {LabelKind::kNewBox, kNone},
                             {LabelKind::kOutlier, kNone}};
  std::vector<int> label_of_node;
  std::vector<ClusterId> previous_of_node;
  for (const Group& group : groups) {
    label_of_node.insert(label_of_node.end(), group.count, group.label);
    previous_of_node.insert(previous_of_node.end(), group.count, group.previous);
  }
  return MatchLabels(labels, {label_of_node, previous_of_node});
}

std::vector<ClusterId> Expect(ClusterId first_box, ClusterId second_box) {
  return {kStaticScene, ClusterId{5}, first_box, second_box, kNone};
}

TEST(MatchLabels, NewBoxContinuesTheClusterOfItsNodes) {
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {5, 2, kNone}, {3, 0, ClusterId{7}}}),
            Expect(ClusterId{7}, kNone));
}

TEST(MatchLabels, RequiresThreeTenthsOfTheUnion) {
  // 3 nodes are shared, of a union of 3 + 5 + 2 and then of 3 + 5 + 3. Nodes without a cluster
  // count in the union.
  EXPECT_EQ(Match({{3, 3, ClusterId{7}}, {5, 3, kNone}, {2, 4, ClusterId{7}}}),
            Expect(kNone, ClusterId{7}));
  EXPECT_EQ(Match({{3, 3, ClusterId{7}}, {5, 3, kNone}, {3, 4, ClusterId{7}}}),
            Expect(kNone, kNone));
}

// Independently, both boxes would take cluster 7. Assigning 8 and 7 shares more nodes in total than
// assigning 7 and none.
TEST(MatchLabels, MatchesBoxesJointly) {
  EXPECT_EQ(Match({{9, 2, ClusterId{7}}, {8, 2, ClusterId{8}}, {8, 3, ClusterId{7}}}),
            Expect(ClusterId{8}, ClusterId{7}));
}

TEST(MatchLabels, ANewBoxMayTakeTheClusterOfALabel) {
  EXPECT_EQ(Match({{10, 2, ClusterId{5}}, {2, 1, ClusterId{5}}}),
            (std::vector<ClusterId>{kStaticScene, kNone, ClusterId{5}, kNone, kNone}));
}

TEST(MatchLabels, ALabelWithoutAMatchKeepsItsClusterIfNoOtherTookIt) {
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {3, 0, ClusterId{5}}}), Expect(ClusterId{7}, kNone));
}

TEST(MatchLabels, StaticSceneIsNeverTaken) {
  EXPECT_EQ(Match({{10, 2, kStaticScene}, {10, 1, kStaticScene}}), Expect(kNone, kNone));
}

constexpr ClusterId kCar{3};

template <typename Policy>
LabelOutcome Repeat(int times, ClusterId inferred, LabelState& state) {
  LabelOutcome outcome = LabelOutcome::kKept;
  for (int i = 0; i < times; ++i) outcome = Policy::Update(inferred, state);
  return outcome;
}

TEST(CountLabels, YieldsAfterAsManyFramesAsItHeld) {
  LabelState state{kStaticScene, 1};
  EXPECT_EQ(Repeat<CountLabels>(200, kStaticScene, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<CountLabels>(200, kCar, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<CountLabels>(1, kCar, state), LabelOutcome::kChanged);
}

TEST(TakeLabelsAtOnce, HasNoMemory) {
  LabelState state{kStaticScene, 1};
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(200, kStaticScene, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(1, kCar, state), LabelOutcome::kChanged);
  EXPECT_EQ(state.cluster, kCar);
  EXPECT_EQ(state.confidence, 1);
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(1, kNone, state), LabelOutcome::kRemove);
}

TEST(CountLabels, OutliersLowerConfidenceUntilTheLandmarkIsRemoved) {
  LabelState state{kCar, 3};
  EXPECT_EQ(Repeat<CountLabels>(2, kNone, state), LabelOutcome::kKept);
  EXPECT_EQ(state.cluster, kCar);
  EXPECT_EQ(state.confidence, 1);
  EXPECT_EQ(Repeat<CountLabels>(1, kNone, state), LabelOutcome::kRemove);
  EXPECT_EQ(state.cluster, kCar);
}

}  // namespace
}  // namespace cvo::extent_test
