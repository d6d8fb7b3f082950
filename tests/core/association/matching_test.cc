// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/rng.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::matching_test {
namespace {

using Policies = ::testing::Types<ProbabilisticAssociation, ProbabilisticAssociationLiteral,
                                  FixedRadiusAssociation>;
using testing::IsEmpty;
using testing::SizeIs;

const StereoCamera kCamera = test::CentredCamera(400, 0.5, 640, 240);

std::vector<StereoFeature> RandomFeatures(int count, Rng& rng) {
  std::vector<StereoFeature> features(static_cast<std::size_t>(count));
  for (StereoFeature& feature : features) {
    const double u = rng.Uniform(0.0, 639.0);
    feature.z_px = {u, rng.Uniform(0.0, 239.0), u - rng.Uniform(1.0, 60.0)};
    feature.descriptor = test::RandomDescriptor(rng);
  }
  return features;
}

ProjectedLandmark LandmarkAt(const StereoFeature& feature, const Eigen::Vector3d& offset_px) {
  return {feature.z_px + offset_px, feature.octave, feature.descriptor};
}

TEST(FeatureGrid, AgreesWithExhaustiveSearch) {
  Rng rng(1, "grid");
  const std::vector<StereoFeature> features = RandomFeatures(400, rng);
  const FeatureGrid grid(features, kCamera);
  for (int trial = 0; trial < 200; ++trial) {
    const double u = rng.Uniform(-50.0, 700.0);
    const double v = rng.Uniform(-50.0, 300.0);
    const double radius = rng.Uniform(0.0, 80.0);
    std::vector<int> found;
    grid.VisitNear(u, v, radius, [&](int index) { found.push_back(index); });
    std::sort(found.begin(), found.end());
    std::vector<int> expected;
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector3d& z = features[i].z_px;
      if (std::abs(z[0] - u) <= radius && std::abs(z[1] - v) <= radius) expected.push_back(i);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(MatchProjected, FindsEachLandmarkWithinTheRadiusOnly) {
  Rng rng(2, "projected");
  const std::vector<StereoFeature> features = RandomFeatures(300, rng);
  const FeatureGrid grid(features, kCamera);
  std::vector<ProjectedLandmark> landmarks;
  for (int i = 0; i < 100; ++i) landmarks.push_back(LandmarkAt(features[i], {3.0, -3.0, 3.0}));
  for (int i = 100; i < 200; ++i) landmarks.push_back(LandmarkAt(features[i], {9.0, 0.0, 9.0}));
  for (int i = 200; i < 300; ++i) landmarks.push_back(LandmarkAt(features[i], {0.0, 0.0, 9.0}));
  const auto matches = MatchProjected(landmarks, grid, 5.0, 1.2, {});
  ASSERT_EQ(matches.size(), 100u);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(matches[i].landmark, i);
    EXPECT_EQ(matches[i].feature, i);
    EXPECT_EQ(matches[i].hamming, 0);
  }
}

TEST(MatchProjected, RefusesAmbiguousCandidates) {
  Rng rng(3, "alike");
  std::vector<StereoFeature> features = RandomFeatures(2, rng);
  features[1] = features[0];
  features[1].z_px += Eigen::Vector3d(2.0, 0.0, 2.0);
  const FeatureGrid grid(features, kCamera);
  const std::vector<ProjectedLandmark> landmarks = {LandmarkAt(features[0], {1.0, 0.0, 1.0})};
  EXPECT_TRUE(MatchProjected(landmarks, grid, 5.0, 1.2, {}).empty());
}

TEST(MatchDescriptors, FindsExactlyTheTruePairsOfWantedFeatures) {
  Rng rng(5, "brute force");
  const std::vector<StereoFeature> features = RandomFeatures(200, rng);
  std::vector<Descriptor> landmarks;
  for (int i = 0; i < 50; ++i) {
    Descriptor noisy = features[2 * i].descriptor;
    for (int k = 0; k < 20; ++k) noisy[rng.UniformInt(4)] ^= 1ull << rng.UniformInt(64);
    landmarks.push_back(noisy);
  }
  for (int i = 0; i < 50; ++i) landmarks.push_back(test::RandomDescriptor(rng));
  const auto matches = MatchDescriptors(
      landmarks, features, [](int i) { return i != 20; }, 60, 0.8);
  ASSERT_EQ(matches.size(), 49u);
  for (const Match& match : matches) {
    EXPECT_EQ(match.feature, 2 * match.landmark);
    EXPECT_NE(match.feature, 20);
  }
}

// P(chi^2 < x) with three degrees of freedom.
double ChiSquare3(double x) {
  return std::erf(std::sqrt(0.5 * x)) - std::sqrt(2.0 * x / std::numbers::pi) * std::exp(-0.5 * x);
}

Eigen::Matrix3d RandomCovariance(Rng& rng) {
  const Eigen::Matrix3d A = Eigen::Matrix3d::NullaryExpr([&] { return rng.Normal(); });
  return A * A.transpose() + 0.3 * Eigen::Matrix3d::Identity();
}

struct Scene {
  std::vector<PredictedLandmark> landmarks;
  std::vector<StereoFeature> features;  // features[i] belongs to landmarks[i]

  FeatureGrid Grid() const { return FeatureGrid(features, kCamera); }
  std::vector<char> NoneTaken() const { return std::vector<char>(features.size(), 0); }

  // Adds a landmark with a unique descriptor, and its feature at `innovation` from the prediction.
  void Add(const Eigen::Matrix3d& position, const Eigen::Matrix3d& measurement,
           const Eigen::Vector3d& innovation, Rng& rng) {
    PredictedLandmark landmark;
    const double u = rng.Uniform(50.0, 590.0);
    landmark.zeta_px = {u, rng.Uniform(50.0, 190.0), u - 20.0};
    landmark.position_px2 = position;
    landmark.measurement_px2 = measurement;
    landmark.innovation_px2 = position + measurement;
    landmark.descriptor = test::RandomDescriptor(rng);
    StereoFeature feature;
    feature.z_px = landmark.zeta_px + innovation;
    feature.descriptor = landmark.descriptor;
    landmarks.push_back(landmark);
    features.push_back(feature);
  }
};

Eigen::Vector3d Draw(const Eigen::Matrix3d& covariance, Rng& rng) {
  const Eigen::Vector3d n(rng.Normal(), rng.Normal(), rng.Normal());
  return Eigen::LLT<Eigen::Matrix3d>(covariance).matrixL() * n;
}

constexpr int kDraws = 5000;

// Draws innovations that are consistent with the covariances of predictions and measurements.
Scene Simulate(Rng& rng) {
  Scene scene;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Matrix3d position = RandomCovariance(rng);
    const Eigen::Matrix3d measurement = RandomCovariance(rng);
    scene.Add(position, measurement, Draw(position + measurement, rng), rng);
  }
  return scene;
}

template <typename Policy>
std::vector<Match> Find(const Scene& scene, const ClusterAssociationOptions& options = {}) {
  return Policy::Find(scene.landmarks, scene.Grid(), scene.NoneTaken(), options);
}

// Returns the fraction of landmarks that were matched, and checks that each matched its feature.
template <typename Policy>
double Acceptance(const Scene& scene, double gamma) {
  ClusterAssociationOptions options;
  options.gamma = gamma;
  const std::vector<Match> matches = Find<Policy>(scene, options);
  for (const Match& match : matches) EXPECT_EQ(match.landmark, match.feature);
  return static_cast<double>(matches.size()) / static_cast<double>(scene.landmarks.size());
}

TEST(ProbabilisticAssociation, AcceptanceRateFollowsChiSquare) {
  Rng rng(1, "gate");
  const Scene scene = Simulate(rng);
  for (const double gamma : {2.0, 4.0, 7.815}) {
    EXPECT_NEAR(Acceptance<ProbabilisticAssociation>(scene, gamma), ChiSquare3(gamma), 0.015)
        << gamma;
  }
}

TEST(ProbabilisticAssociationLiteral, RejectsMostTrueMatches) {
  Rng rng(2, "gate");
  Scene scene;
  for (int i = 0; i < kDraws; ++i) {
    // For a perfectly predicted body at constant depth, Gamma equals Sigma_z (METHOD.md 4.2).
    const Eigen::Matrix3d covariance = RandomCovariance(rng);
    scene.Add(covariance, covariance, Draw(2.0 * covariance, rng), rng);
  }
  EXPECT_NEAR(Acceptance<ProbabilisticAssociationLiteral>(scene, 4.0), 0.43, 0.015);
  EXPECT_NEAR(Acceptance<ProbabilisticAssociation>(scene, 4.0), 0.74, 0.015);
}

TEST(AddLeftOnlyMatches, FindsLandmarksLeftOfTheRightImage) {
  Rng rng(4, "gate");
  Scene scene;
  const Eigen::Matrix3d still = Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d measurement = Eigen::Matrix3d::Identity();
  for (const double du_px : {1.0, 1.0, 5.0, 0.0, 0.0}) {
    scene.Add(still, measurement, {du_px, 0.0, 20.0}, rng);
    if (scene.landmarks.size() < 5) scene.landmarks.back().zeta_px[2] = -3.0;
  }
  // The second has a disparity, the third is too far away, the fourth is already matched and the
  // fifth should be visible in the right image.
  for (const int i : {0, 2, 3, 4}) scene.features[i].disagreement_px = kNoDisparity_px;
  std::vector<Match> matches = {{3, 1, 0}};
  const std::vector<char> is_taken(scene.features.size(), 0);
  AddLeftOnlyMatches(scene.landmarks, scene.Grid(), is_taken, {}, matches);
  ASSERT_THAT(matches, SizeIs(2));
  EXPECT_EQ(matches[1].landmark, 0);
  EXPECT_EQ(matches[1].feature, 0);
}

TEST(ProbabilisticAssociation, GateIsAnEllipsoidInAllThreeCoordinates) {
  Rng rng(3, "gate");
  // u_left and u_right are correlated: a disparity error is far less likely than a common shift.
  Eigen::Matrix3d covariance;
  covariance << 4.0, 0.0, 3.9,  //
      0.0, 1.0, 0.0,            //
      3.9, 0.0, 4.0;
  const auto is_found = [&](const Eigen::Vector3d& innovation) {
    Scene scene;
    scene.Add(Eigen::Matrix3d::Zero(), covariance, innovation, rng);
    return !Find<ProbabilisticAssociation>(scene).empty();
  };
  EXPECT_TRUE(is_found({3.9, 0.0, 3.9}));    // 15.2 / 3.95 = 3.9
  EXPECT_FALSE(is_found({4.1, 0.0, 4.1}));   // 16.8 / 3.95 = 4.3
  EXPECT_FALSE(is_found({1.0, 0.0, -1.0}));  // 2 / 0.1 = 20
  EXPECT_TRUE(is_found({0.0, 1.9, 0.0}));    // 3.61
  EXPECT_FALSE(is_found({0.0, 2.1, 0.0}));   // 4.41
}

TEST(ProbabilisticAssociation, IgnoresLandmarksWithDegenerateCovariance) {
  Rng rng(5, "gate");
  Scene scene;
  scene.Add(Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero(), rng);
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), IsEmpty());
  scene.landmarks[0].innovation_px2.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), IsEmpty());
  scene.landmarks[0].innovation_px2.setIdentity();
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), SizeIs(1));
}

TEST(ProbabilisticAssociation, ChoosesByDescriptorWithinTheGate) {
  Rng rng(6, "gate");
  Scene scene;
  const Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  scene.Add(covariance, covariance, {1.0, 0.0, 1.0}, rng);
  // A feature of another point is nearer, but its descriptor differs by 20 bits.
  StereoFeature nearer = scene.features[0];
  nearer.z_px = scene.landmarks[0].zeta_px;
  nearer.descriptor[0] ^= 0xFFFFFull;
  scene.features.push_back(nearer);
  const std::vector<Match> matches = Find<ProbabilisticAssociation>(scene);
  ASSERT_THAT(matches, SizeIs(1));
  EXPECT_EQ(matches[0].feature, 0);
  EXPECT_EQ(matches[0].hamming, 0);
}

TEST(ProbabilisticAssociation, RefusesAmbiguousOrDissimilarMatches) {
  Rng rng(7, "gate");
  Scene scene;
  const Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  scene.Add(covariance, covariance, {1.0, 0.0, 1.0}, rng);
  scene.landmarks[0].descriptor[0] ^= 0x3FFull;  // 10 bits
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), SizeIs(1));
  StereoFeature second = scene.features[0];
  second.z_px = scene.landmarks[0].zeta_px;
  second.descriptor[1] ^= 1ull;  // 11 bits from the landmark: 10 >= 0.9 * 11
  scene.features.push_back(second);
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), IsEmpty());
  // Outside the gate it is not a competing candidate.
  scene.features[1].z_px += Eigen::Vector3d(9.0, 0.0, 9.0);
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), SizeIs(1));
  scene.landmarks[0].descriptor[2] ^= ~0ull;  // 74 bits
  scene.landmarks[0].descriptor[3] ^= 1ull;
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), SizeIs(1));
  scene.landmarks[0].descriptor[3] ^= 2ull;  // 76
  EXPECT_THAT(Find<ProbabilisticAssociation>(scene), IsEmpty());
}

template <typename Policy>
class EveryAssociation : public testing::Test {};
TYPED_TEST_SUITE(EveryAssociation, Policies);

TYPED_TEST(EveryAssociation, GivesAFeatureToTheMostSimilarLandmarkOnly) {
  Rng rng(8, "gate");
  Scene scene;
  const Eigen::Matrix3d covariance = 4.0 * Eigen::Matrix3d::Identity();
  scene.Add(covariance, covariance, {1.0, 0.0, 1.0}, rng);
  scene.landmarks.insert(scene.landmarks.begin(), scene.landmarks[0]);
  scene.landmarks[0].descriptor[0] ^= 7ull;
  const std::vector<Match> matches = Find<TypeParam>(scene);
  ASSERT_THAT(matches, SizeIs(1));
  EXPECT_EQ(matches[0].landmark, 1);
  EXPECT_EQ(matches[0].feature, 0);
}

TYPED_TEST(EveryAssociation, IgnoresTakenFeaturesAndDistantOctaves) {
  Rng rng(9, "gate");
  Scene scene;
  const Eigen::Matrix3d covariance = 4.0 * Eigen::Matrix3d::Identity();
  scene.Add(covariance, covariance, {1.0, 0.0, 1.0}, rng);
  EXPECT_THAT(TypeParam::Find(scene.landmarks, scene.Grid(), {1}, {}), IsEmpty());
  scene.features[0].octave = 1;
  EXPECT_THAT(Find<TypeParam>(scene), SizeIs(1));
  scene.features[0].octave = 2;
  EXPECT_THAT(Find<TypeParam>(scene), IsEmpty());
}

TYPED_TEST(EveryAssociation, FindsNothingWithoutLandmarksOrFeatures) {
  Rng rng(10, "gate");
  Scene scene;
  EXPECT_THAT(Find<TypeParam>(scene), IsEmpty());
  scene.Add(Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity(), {0, 0, 0}, rng);
  scene.features.clear();
  EXPECT_THAT(Find<TypeParam>(scene), IsEmpty());
}

TEST(FixedRadiusAssociation, IgnoresCovariances) {
  Rng rng(11, "gate");
  const double radius = 20.0;
  for (const double size : {1e-12, 1.0, 1e9}) {
    const Eigen::Matrix3d covariance = size * Eigen::Matrix3d::Identity();
    Scene scene;
    scene.Add(covariance, covariance, {radius - 0.5, 0.5 - radius, radius - 0.5}, rng);
    EXPECT_THAT(Find<FixedRadiusAssociation>(scene), SizeIs(1));
    for (int k = 0; k < 3; ++k) {
      Scene beyond = scene;
      beyond.features[0].z_px[k] += k == 1 ? -1.0 : 1.0;
      EXPECT_THAT(Find<FixedRadiusAssociation>(beyond), IsEmpty());
    }
  }
}

}  // namespace
}  // namespace cvo::matching_test
