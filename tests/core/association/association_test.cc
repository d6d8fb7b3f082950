// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/association/descriptor_matching.h"
#include "core/association/projected_matching.h"
#include "core/base/rng.h"
#include "tests/support/centred_camera.h"
#include "tests/support/random_descriptor.h"

namespace cvo::association_test {
namespace {

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

TEST(FeatureGrid, FindsOnlyTheSelectedFeatures) {
  Rng rng(4, "grid_of_some");
  const std::vector<StereoFeature> features = RandomFeatures(50, rng);
  const std::vector<int> which = {3, 17, 40};
  const FeatureGrid grid(features, kCamera, which);
  std::vector<int> found;
  grid.VisitNear(0.0, 0.0, 1e4, [&](int index) { found.push_back(index); });
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, which);
  EXPECT_EQ(grid.features().size(), 50u);
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

TEST(MatchProjected, MatchesOnlyNeighbouringOctaves) {
  Rng rng(4, "octave");
  std::vector<StereoFeature> features = RandomFeatures(1, rng);
  features[0].octave = 4;
  const FeatureGrid grid(features, kCamera);
  for (int octave = 0; octave < 8; ++octave) {
    ProjectedLandmark landmark = LandmarkAt(features[0], Eigen::Vector3d::Zero());
    landmark.octave = octave;
    EXPECT_EQ(MatchProjected({&landmark, 1}, grid, 5.0, 1.2, {}).size(),
              std::abs(octave - 4) <= 1 ? 1u : 0u);
  }
}

TEST(KeepOneToOne, PrefersTheNearestAndBreaksTiesByIndex) {
  const std::vector<Match> kept = KeepOneToOne({{0, 5, 10}, {1, 5, 4}, {2, 6, 7}, {0, 6, 7}}, 3, 7);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].landmark, 0);
  EXPECT_EQ(kept[0].feature, 6);
  EXPECT_EQ(kept[1].landmark, 1);
  EXPECT_EQ(kept[1].feature, 5);
}

TEST(MatchDescriptors, FindsExactlyTheTruePairs) {
  Rng rng(5, "brute force");
  const std::vector<StereoFeature> features = RandomFeatures(200, rng);
  std::vector<Descriptor> landmarks;
  for (int i = 0; i < 50; ++i) {
    Descriptor noisy = features[2 * i].descriptor;
    for (int k = 0; k < 20; ++k) noisy[rng.UniformInt(4)] ^= 1ull << rng.UniformInt(64);
    landmarks.push_back(noisy);
  }
  for (int i = 0; i < 50; ++i) landmarks.push_back(test::RandomDescriptor(rng));
  const auto matches = MatchDescriptors(landmarks, features, 60, 0.8);
  ASSERT_EQ(matches.size(), 50u);
  for (const Match& match : matches) EXPECT_EQ(match.feature, 2 * match.landmark);
}

TEST(MatchDescriptors, EmptyInputsGiveNoMatches) {
  Rng rng(6, "empty");
  const std::vector<StereoFeature> features = RandomFeatures(3, rng);
  EXPECT_TRUE(MatchDescriptors({}, features, 60, 0.8).empty());
  const std::vector<Descriptor> landmarks = {test::RandomDescriptor(rng)};
  EXPECT_TRUE(MatchDescriptors(landmarks, {}, 60, 0.8).empty());
}

}  // namespace
}  // namespace cvo::association_test
