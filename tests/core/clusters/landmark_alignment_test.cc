// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/clusters/cluster_association.h"
#include "core/clusters/cluster_prediction.h"
#include "core/clusters/trace_back.h"
#include "tests/core/clusters/small_windows.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::landmark_alignment_test {
namespace {

using test::At;
using test::kCamera;
using test::StateAt;

constexpr double kScaleFactor = 1.2;

// A patch of blobs around the corner, which is `shift_px` off the middle of the patch.
FeaturePatch Blobs(double shift_px) {
  FeaturePatch patch;
  for (int y = 0; y < FeaturePatch::kSide_px; ++y) {
    for (int x = 0; x < FeaturePatch::kSide_px; ++x) {
      const double u = x - FeaturePatch::kRadius_px - shift_px;
      const double v = y - FeaturePatch::kRadius_px;
      patch.pixels[y * FeaturePatch::kSide_px + x] = static_cast<std::uint8_t>(
          std::lround(100.0 + 60.0 * std::sin(0.8 * u) * std::cos(0.6 * v) + 5.0 * v));
    }
  }
  return patch;
}

class LandmarkAlignmentTest : public testing::Test {
 protected:
  LandmarkAlignmentTest() {
    landmark_.p_in_object = {0.0, 0.0, 10.0};
    landmark_.reference = {Blobs(0.0), 10.0};
    feature_.z_px = {100.0, 50.0, 80.0};
    feature_.patch = Blobs(0.5);
  }
  void Align() {
    std::vector<StereoFeature> features = {feature_};
    AlignToLandmarks(kScaleFactor, RigidTransform(), {landmark_}, {{0, 0}}, features);
    feature_ = features[0];
  }

  Landmark landmark_;
  StereoFeature feature_;
};

TEST_F(LandmarkAlignmentTest, MovesBothColumnsAndKeepsTheDisparity) {
  Align();
  EXPECT_TRUE(feature_.is_aligned);
  EXPECT_NEAR(feature_.z_px[0], 100.5, 0.03);
  EXPECT_NEAR(feature_.z_px[1], 50.0, 0.03);
  EXPECT_NEAR(feature_.z_px[0] - feature_.z_px[2], 20.0, 1e-9);
  EXPECT_NEAR(feature_.patch.corner_u, 0.5, 0.03);
}

TEST_F(LandmarkAlignmentTest, ScalesTheShiftToFullResolutionOnCoarseLevels) {
  feature_.octave = 4;
  const double scale = std::pow(kScaleFactor, 4);
  landmark_.reference.size_m = 10.0 * scale;
  Align();
  EXPECT_NEAR(feature_.z_px[0], 100.0 + 0.5 * scale, 0.03 * scale);
}

TEST_F(LandmarkAlignmentTest, LeavesTheCornerIfTheLandmarkLooksDifferent) {
  for (auto& pixel : landmark_.reference.patch.pixels) pixel = 255 - pixel;
  Align();
  EXPECT_FALSE(feature_.is_aligned);
  EXPECT_EQ(feature_.z_px[0], 100.0);
}

TEST_F(LandmarkAlignmentTest, LeavesTheCornerWithoutTheOption) {
  const StereoCamera camera = test::CentredCamera(400, 0.5, 640, 240);
  StereoFrame frame;
  frame.features = {feature_};
  const FeatureGrid grid(frame.features, camera);
  Cluster cluster;
  cluster.landmarks = {landmark_};
  ClusterTrack track;
  track.matches = {{0, 0}};
  Options options;
  const FrameView view{frame, {}, grid, camera, {}, options};
  options.tracking.align_patches = false;
  PlaceFeatures(view, cluster, track, frame.features);
  EXPECT_EQ(frame.features[0].z_px[0], 100.0);
  options.tracking.align_patches = true;
  PlaceFeatures(view, cluster, track, frame.features);
  EXPECT_NEAR(frame.features[0].z_px[0], 100.5, 0.03);
}

TEST_F(LandmarkAlignmentTest, KeepsTheReferenceUntilItsSizeChangesSubstantially) {
  landmark_.depth_m = 9.0;
  feature_.is_aligned = true;
  UpdateReference(kScaleFactor, feature_, landmark_);
  EXPECT_EQ(landmark_.reference.size_m, 10.0);
  landmark_.depth_m = 7.0;
  UpdateReference(kScaleFactor, feature_, landmark_);
  EXPECT_EQ(landmark_.reference.size_m, 7.0);
  EXPECT_EQ(landmark_.reference.patch.pixels, feature_.patch.pixels);
}

TEST(FeatureNoise, TrustsAlignedCornersMore) {
  const FeatureNoise noise{{.corner_px = 0.5, .aligned_px = 0.1, .disparity_px = 0.3}, 1.2};
  EXPECT_NEAR(noise.SqrtInformation(0, false, 0.0)(0, 0), 2.0, 1e-12);
  EXPECT_NEAR(noise.SqrtInformation(0, true, 0.0)(0, 0), 10.0, 1e-12);
  EXPECT_EQ(noise.SqrtInformation(0, true, 0.1).row(2),
            noise.SqrtInformation(0, false, 0.1).row(2));
}

TEST(FeatureNoise, DisparityNoiseFollowsThePatchDisagreement) {
  FeatureNoise noise{{.disparity_px = 0.3, .least_disparity_px = 0.03, .disagreement = 2.0}, 2.0};
  const auto sigma = [&](int octave, double disagreement_px) {
    return -1.0 / noise.SqrtInformation(octave, false, disagreement_px)(2, 2);
  };
  EXPECT_NEAR(sigma(0, 0.0), 0.03, 1e-12);
  EXPECT_NEAR(sigma(0, 0.02), 0.05, 1e-12);
  EXPECT_NEAR(sigma(2, 0.02), 0.2, 1e-12);
  noise.options.disagreement = 0.0;
  EXPECT_NEAR(sigma(0, 0.02), 0.3, 1e-12);
}

TEST(FeatureNoise, LeftOnlyFeaturesHaveNoDisparityInformation) {
  FeatureNoise noise{{.corner_px = 0.5, .aligned_px = 0.1}, 1.2};
  for (const double disagreement : {0.0, 3.0}) {
    noise.options.disagreement = disagreement;
    const Eigen::Matrix3d W = noise.SqrtInformation(0, false, kNoDisparity_px);
    EXPECT_NEAR(W(0, 0), 2.0, 1e-12);
    EXPECT_LE(W.row(2).norm(), 2e-3);
  }
}

TEST(PlaceLeftOnly, TakesTheDisparityFromTheLandmarkForLeftOnlyFeatures) {
  const StereoCamera camera = test::CentredCamera(400, 0.5, 640, 240);
  Landmark landmark;
  landmark.p_in_object = {-1.0, 0.2, 3.0};
  const RigidTransform camera_from_object(Eigen::Quaterniond::Identity(),
                                          Eigen::Vector3d(0.0, 0.0, 1.0));
  std::vector<StereoFeature> features(2);
  features[0].z_px = features[1].z_px = {221.0, 140.0, 221.0};
  features[0].disagreement_px = kNoDisparity_px;
  PlaceLeftOnly(camera, camera_from_object, {landmark}, {{0, 0, 10}, {0, 1, 10}}, features);
  EXPECT_NEAR(features[0].z_px[2], 221.0 - 400 * 0.5 / 4.0, 1e-9);
  EXPECT_EQ(features[0].z_px[0], 221.0);
  EXPECT_EQ(features[1].z_px[2], 221.0);
}

}  // namespace
}  // namespace cvo::landmark_alignment_test
