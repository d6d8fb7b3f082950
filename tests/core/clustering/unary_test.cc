// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/clustering/unary_terms.h"
#include "tests/support/error_message.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::unary_test {
namespace {

using test::MakeLabel;
using test::NodeAt;
using testing::HasSubstr;

constexpr ImageBox kLeft = {100, 100, 200, 200};
constexpr ImageBox kRight = {150, 100, 250, 200};
constexpr ImageBox kMissed = {180, 150, 400, 300};

// Labels: the static scene, a cluster and a new box that overlap in the image, a cluster that the
// detector missed, outliers.
CrfScene BoxScene() {
  CrfScene scene;
  scene.camera = test::kSceneCamera;
  scene.labels = {MakeLabel(LabelKind::kStatic), MakeLabel(LabelKind::kCluster),
                  MakeLabel(LabelKind::kNewBox), MakeLabel(LabelKind::kCluster),
                  MakeLabel(LabelKind::kOutlier)};
  scene.labels[1].box = kLeft;
  scene.labels[2].box = kRight;
  scene.labels[3].predicted_box = kMissed;
  return scene;
}

CrfNode NodeSeenAt(double u_px, double v_px) {
  CrfNode node;
  node.z_px = {u_px, v_px, u_px - 10.0};
  return node;
}

template <typename Term>
std::vector<double> Probabilities(CrfScene scene, const CrfNode& node,
                                  const UnaryOptions& options = {}) {
  scene.nodes = {node};
  const EnergyMatrix energies = TermEnergies<Term>(scene, options);
  std::vector<double> probabilities;
  for (const double energy : energies.row(0)) probabilities.push_back(std::exp(-energy));
  return probabilities;
}

template <typename Term>
Eigen::RowVectorXd RawEnergies(CrfScene scene, const CrfNode& node,
                               const UnaryOptions& options = {}) {
  scene.nodes = {node};
  EnergyMatrix energies(1, static_cast<Eigen::Index>(scene.labels.size()));
  Term::Energies(scene, options, energies);
  return energies.row(0);
}

auto Near(const std::vector<double>& expected) {
  return testing::Pointwise(testing::DoubleNear(1e-12), expected);
}

TEST(NormalizeEnergies, ProbabilitiesSumToOne) {
  EnergyMatrix energies(2, 3);
  energies << 1.0, 2.0, 3.5, 1000.0, 1001.0, 1000.0;
  NormalizeEnergies(100.0, energies);
  EXPECT_NEAR((-energies.row(0)).array().exp().sum(), 1.0, 1e-12);
  EXPECT_NEAR((-energies.row(1)).array().exp().sum(), 1.0, 1e-12);
  EXPECT_NEAR(energies(0, 1) - energies(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(energies(1, 0), std::log(2.0 + std::exp(-1.0)), 1e-12);
}

TEST(NormalizeEnergies, RefusesNan) {
  EnergyMatrix energies(2, 2);
  energies << 1.0, 2.0, std::nan(""), 1.0;
  EXPECT_THAT(ErrorMessage([&] { NormalizeEnergies(15.0, energies); }), HasSubstr("node 1"));
}

const std::vector<double> kInLeft = {0.0125, 0.95, 0.0125, 0.0125, 0.0125};
const std::vector<double> kInBoth = {0.05 / 3, 0.475, 0.475, 0.05 / 3, 0.05 / 3};
const std::vector<double> kOutside = {0.95, 0.0125, 0.0125, 0.0125, 0.0125};

TEST(Box2dTerm, SharesProbabilityAmongTheBoxesThatContainTheLandmark) {
  const CrfScene scene = BoxScene();
  EXPECT_THAT(Probabilities<Box2dTerm>(scene, NodeSeenAt(120, 150)), Near(kInLeft));
  EXPECT_THAT(Probabilities<Box2dTerm>(scene, NodeSeenAt(170, 150)), Near(kInBoth));
  EXPECT_THAT(Probabilities<Box2dTerm>(scene, NodeSeenAt(500, 150)), Near(kOutside));
  // A missed body shares its predicted box with the static scene, or with what is detected there.
  EXPECT_THAT(Probabilities<Box2dTerm>(scene, NodeSeenAt(220, 180)),
              Near({0.05 / 3, 0.05 / 3, 0.475, 0.475, 0.05 / 3}));
  EXPECT_THAT(Probabilities<Box2dTerm>(scene, NodeSeenAt(390, 290)),
              Near({0.475, 0.05 / 3, 0.05 / 3, 0.475, 0.05 / 3}));
  EXPECT_THAT(Probabilities<DetectedBox2dTerm>(scene, NodeSeenAt(390, 290)), Near(kOutside));
  EXPECT_THAT(Probabilities<DetectedBox2dTerm>(scene, NodeSeenAt(120, 150)), Near(kInLeft));
}

TEST(Box2dTermLiteral, MatchesThePrintedFormula) {
  const CrfScene scene = BoxScene();
  EXPECT_THAT(Probabilities<Box2dTermLiteral>(scene, NodeSeenAt(104, 150)), Near(kInLeft));
  EXPECT_THAT(Probabilities<Box2dTermLiteral>(scene, NodeSeenAt(170, 150)), Near(kInBoth));
  // No label is preferred: all energies are zero.
  EXPECT_THAT(Probabilities<Box2dTermLiteral>(scene, NodeSeenAt(390, 290)), Near({1, 1, 1, 1, 1}));
}

// Labels: the static scene, a detected body 10 m ahead whose long side (its first axis) points
// down, a new body of unknown size, outliers.
CrfScene AffinityScene() {
  CrfScene scene;
  scene.camera = test::kSceneCamera;
  scene.labels = {MakeLabel(LabelKind::kStatic), MakeLabel(LabelKind::kCluster),
                  MakeLabel(LabelKind::kNewBox), MakeLabel(LabelKind::kOutlier)};
  CrfLabel::Extent extent;
  extent.center_in_camera = {1.0, 0.5, 10.0};
  extent.camera_from_axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  extent.half_size_m = {0.6, 0.1, 0.2};
  scene.labels[1].extent = extent;
  scene.labels[1].box = kLeft;
  return scene;
}

TEST(AffinityTerm, MatchesHandComputedValues) {
  CrfNode node = NodeAt({1.0, 1.8, 10.0});
  node.covariance_m2 = Eigen::Vector3d(0.01, 0.25, 1.0).asDiagonal();
  // 1.3 m along the long side, with a variance of 0.25 + 4 * 0.36 = 1.69 m^2.
  EXPECT_NEAR(RawEnergies<AffinityTerm>(AffinityScene(), node)[1], 0.5, 1e-12);
  node.p_in_camera = {1.1, 0.5, 10.0};
  // 0.1 m along a short side, with a variance of 0.01 + 4 * 0.01 = 0.05 m^2.
  EXPECT_NEAR(RawEnergies<AffinityTerm>(AffinityScene(), node)[1], 0.1, 1e-12);
}

TEST(AffinityTerm, IsZeroNearTheCentreOfAnUndetectedBody) {
  const CrfScene detected = AffinityScene();
  CrfScene missed = detected;
  missed.labels[1].box.reset();
  const CrfNode inside = NodeAt({1.0, 1.1, 10.0});
  EXPECT_GT(RawEnergies<AffinityTerm>(detected, inside)[1], 0.0);
  EXPECT_EQ(RawEnergies<AffinityTerm>(missed, inside)[1], 0.0);
  const CrfNode outside = NodeAt({1.0, 10.5, 10.0});
  const double energy = RawEnergies<AffinityTerm>(detected, outside)[1];
  EXPECT_NEAR(RawEnergies<AffinityTerm>(missed, outside)[1], energy - 0.5 * 1.7 * 1.7, 1e-12);
  EXPECT_EQ(RawEnergies<AffinityTerm>(missed, outside, {.undetected_reach = 0.0})[1], energy);
}

TEST(AffinityTerm, PrunesTheBackgroundButNotPointsOfUncertainDepth) {
  CrfNode node = NodeAt({1.0, 0.5, 13.0});
  node.covariance_m2 = Eigen::Vector3d(0.01, 0.01, 0.04).asDiagonal();
  EXPECT_LT(Probabilities<AffinityTerm>(AffinityScene(), node)[1], 0.01);
  node.covariance_m2(2, 2) = 9.0;  // its depth is highly uncertain
  const auto probabilities = Probabilities<AffinityTerm>(AffinityScene(), node);
  EXPECT_GT(probabilities[1], probabilities[0]);
}

TEST(AffinityTermLiteral, MatchesThePrintedFormula) {
  CrfNode node = NodeAt({1.0, 0.8, 10.5});
  node.covariance_m2 << 0.02, 0.0, 0.0, 0.0, 0.02, 0.01, 0.0, 0.01, 0.08;
  const Eigen::Vector3d d(0.0, 0.3, 0.5);
  const double expected = d.dot(node.covariance_m2.inverse() * d) / (0.3 * 0.3);
  EXPECT_NEAR(RawEnergies<AffinityTermLiteral>(AffinityScene(), node)[1], expected, 1e-9);
}

TEST(ComputeUnaries, AddsUpItsTerms) {
  CrfScene scene = AffinityScene();
  scene.labels[1].box = kLeft;
  scene.nodes = {NodeAt({1.0, 0.5, 10.0}), NodeAt({-1.0, 0.5, 12.0}), NodeAt({3.0, 0.2, 10.0})};
  const EnergyMatrix box = TermEnergies<Box2dTerm>(scene, {});
  const EnergyMatrix affinity = TermEnergies<AffinityTerm>(scene, {});
  EXPECT_EQ((ComputeUnaries<Box2dTerm, NoTerm, NoTerm>(scene, {})), box);
  const EnergyMatrix both = ComputeUnaries<Box2dTerm, AffinityTerm>(scene, {});
  EXPECT_TRUE(both.isApprox(box + affinity));
  EXPECT_FALSE(both.isApprox(box));
}

}  // namespace
}  // namespace cvo::unary_test
