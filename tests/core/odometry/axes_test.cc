// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the axes: the requirements on policies, and which axes an ablation changes.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "variants/all.h"
#include "variants/instantiate.h"

namespace cvo {
namespace {

template <typename Policy>
concept HasRvalueOverload = requires {
  Policy::Show(StereoFrame());
};

struct MisspeltAxis : Full {
  using BoxRematches = NoBoxRematch;
};
struct WrongPolicy : Full {
  using Identity = NoBoxRematch;
};

TEST(Axes, AblationsChangeTheStatedAxes) {
  EXPECT_EQ((CountDifferences<Full, Full>()), 0);
  EXPECT_EQ((CountDifferences<Full, MisspeltAxis>()), 0);
  EXPECT_EQ((CountDifferences<Full, Only2d>()), 2);
  EXPECT_EQ((CountDifferences<Static, Only2d>()), 3);
}

TEST(Axes, PolicyOfAnotherAxisIsRefused) {
  EXPECT_TRUE(EstimatorVariant<Full>);
  EXPECT_FALSE(EstimatorVariant<WrongPolicy>);
}

TEST(Axes, MatchingAndIdentityChangeIndependently) {
  EXPECT_TRUE((std::is_same_v<WithoutBoxRematch::Identity, Full::Identity>));
  EXPECT_TRUE((std::is_same_v<AddIdentity<Full>::BoxRematch, Full::BoxRematch>));
}

TEST(DetectionPolicies, ShowTheFrameItselfOrNothing) {
  StereoFrame frame;
  frame.features.resize(2);
  frame.detections.resize(1);
  frame.given.feature_body = {kStaticBody, BodyId{3}};
  frame.given.detection_body = {BodyId{3}};
  const ShownBodies shown = UseDetections::Show(frame);
  EXPECT_EQ(shown.detections.data(), frame.detections.data());
  EXPECT_EQ(shown.feature_body.data(), frame.given.feature_body.data());
  EXPECT_EQ(shown.detection_body.data(), frame.given.detection_body.data());
  const ShownBodies none = IgnoreDetections::Show(frame);
  EXPECT_TRUE(none.detections.empty());
  EXPECT_TRUE(none.feature_body.empty());
  EXPECT_TRUE(none.detection_body.empty());
}

TEST(DetectionPolicies, RefuseTemporaryFrames) { EXPECT_FALSE(HasRvalueOverload<UseDetections>); }

TEST(Instantiate, CreatesOnlyItsOwnVariants) {
  TaskPool pool(1);
  const OdometrySetup setup{{400.0, 400.0, 320.0, 240.0, 0.2, 640, 480}, {}, 0};
  EXPECT_NE(Instantiate<1>(1, setup, pool), nullptr);
  EXPECT_THROW(Instantiate<1>(2, setup, pool), Error);
}

}  // namespace
}  // namespace cvo
