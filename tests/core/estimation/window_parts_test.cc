// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests parts of the window in isolation: visibility, promotion of frames, and the arrays of a
// problem.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/estimation/double_track.h"
#include "core/estimation/window_problem.h"
#include "tests/support/centred_camera.h"

namespace cvo::window_parts_test {
namespace {

const StereoCamera kCamera = test::CentredCamera(500, 0.5, 640, 480);

RigidTransform At(double z, double turn_rad = 0.0) {
  return {ExpSo3({0.0, turn_rad, 0.0}), Eigen::Vector3d(0.0, 0.0, z)};
}

Landmark Seen(int id, double z, const std::vector<int>& frames) {
  Landmark landmark;
  landmark.id = LandmarkId{id};
  landmark.p_in_object = {0.0, 0.0, z};
  for (const int frame : frames) {
    landmark.observations.push_back({FrameId{frame}, Eigen::Vector3d(id, frame, 0.5)});
  }
  return landmark;
}

// Returns a window with frame 0 in T_s, frames 4 and 5 in T_t, and ten landmarks at 1 ... 10 m that
// are observed in frame 0.
Window MakeWindow(const std::vector<int>& seen_by_4) {
  Window window;
  window.camera = kCamera;
  window.prior = CalibrationPrior(kCamera, Vector6d::Ones());
  window.spatial = {{FrameId{0}, At(0.0)}};
  window.temporal = {{FrameId{4}, At(0.0)}, {FrameId{5}, At(1.0)}};
  for (int id = 0; id < 10; ++id) {
    const bool also = std::find(seen_by_4.begin(), seen_by_4.end(), id) != seen_by_4.end();
    window.landmarks.push_back(
        Seen(id, id + 1.0, also ? std::vector<int>{0, 4} : std::vector<int>{0}));
  }
  return window;
}

TEST(Window, CountsAndFindsObservations) {
  const Window window = MakeWindow({1, 3, 8});
  EXPECT_EQ(window.CountLandmarks(FrameId{0}), 10);
  EXPECT_EQ(window.CountLandmarks(FrameId{4}), 3);
  EXPECT_EQ(window.CountLandmarks(FrameId{5}), 0);
  EXPECT_EQ(window.CountCommonLandmarks(FrameId{4}, FrameId{0}), 3);
  EXPECT_EQ(window.CountCommonLandmarks(FrameId{4}, FrameId{5}), 0);
  EXPECT_EQ(FindObservation(window.landmarks[1], FrameId{4}), &window.landmarks[1].observations[1]);
  for (const int frame : {-1, 2, 5}) {
    EXPECT_EQ(FindObservation(window.landmarks[1], FrameId{frame}), nullptr) << frame;
  }
  EXPECT_EQ(window.Find(FrameId{0}), &window.spatial[0]);
  EXPECT_EQ(window.Find(FrameId{5}), &window.temporal[1]);
  EXPECT_EQ(window.Find(FrameId{3}), nullptr);
  ASSERT_EQ(window.Frames().size(), 3U);
  EXPECT_EQ(window.Frames()[1]->id, FrameId{4});
}

TEST(Window, MedianDepthIsOverLandmarksOfTheFrame) {
  Window window = MakeWindow({1, 3, 8});
  EXPECT_DOUBLE_EQ(window.MedianDepth(FrameId{4}), 4.0);  // of 2, 4 and 9 m
  EXPECT_DOUBLE_EQ(window.MedianDepth(FrameId{0}), 6.0) << "the upper of the middle two";
  EXPECT_EQ(window.MedianDepth(FrameId{5}), 0.0) << "sees none";
  EXPECT_EQ(window.MedianDepth(FrameId{7}), 0.0) << "not in the window";
  window.temporal[0].world_from_camera = At(-3.0);
  EXPECT_DOUBLE_EQ(window.MedianDepth(FrameId{4}), 7.0) << "from where it is";
}

TEST(Window, RemovesObservationsWithTheirFrame) {
  Window window = MakeWindow({1, 3, 8});
  window.RemoveObservations(FrameId{0});
  EXPECT_EQ(window.landmarks.size(), 10U);
  EXPECT_EQ(window.landmarks[1].observations.size(), 1U);
  window.RemoveUnobserved();
  ASSERT_EQ(window.landmarks.size(), 3U);
  EXPECT_EQ(window.landmarks[2].id, LandmarkId{8});
}

TEST(PromoteDistant, PromotesByRotationDistanceOrOverlap) {
  const std::vector<int> all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const WindowOptions options = {
      .promote_translation = 0.25, .promote_rotation_rad = 0.2, .promote_common = 0.5};
  const auto promotes = [&](const Window& window, const RigidTransform& pose) {
    return PromoteDistant::Promotes(window, {FrameId{4}, pose}, options);
  };
  const Window window = MakeWindow(all);
  EXPECT_FALSE(promotes(window, At(0.0)));
  EXPECT_TRUE(promotes(window, At(0.0, 0.21)));
  EXPECT_FALSE(promotes(window, At(0.0, -0.19)));
  // A quarter of the median depth of 6 m.
  EXPECT_FALSE(promotes(window, At(1.5)));
  EXPECT_TRUE(promotes(window, At(1.6)));
  EXPECT_TRUE(promotes(window, At(-1.6)));
  // Half of the ten landmarks.
  EXPECT_FALSE(promotes(MakeWindow({0, 1, 2, 3, 4}), At(0.0)));
  EXPECT_TRUE(promotes(MakeWindow({0, 1, 2, 3}), At(0.0)));
  Window first = window;
  first.spatial.clear();
  EXPECT_TRUE(promotes(first, At(0.0))) << "there is none to compare with";
}

TEST(CalibrationPolicies, EstimateFieldOrShift) {
  const NoiseOptions noise{.right_mean_px = 0.1, .right_field_px = 0.2};
  const Vector6d field = EstimateRightField::Deviation(noise);
  const Vector6d shift = EstimateRightShift::Deviation(noise);
  EXPECT_EQ(field, (Vector6d() << 0.1, 0.2, 0.2, 0.2, 0.2, 0.2).finished());
  EXPECT_EQ(shift[0], 0.1);
  for (int k = 1; k < 6; ++k) EXPECT_DOUBLE_EQ(shift[k], 1e-6) << "a millionth of a pixel";
}

TEST(WindowProblem, ContainsTheFramesAndAddedLandmarks) {
  const Window window = MakeWindow({1, 3, 8});
  WindowProblem problem = MakeFrames(window);
  EXPECT_EQ(problem.frames, (std::vector<FrameId>{FrameId{0}, FrameId{4}, FrameId{5}}));
  EXPECT_EQ(problem.is_fixed, (std::vector<char>{0, 0, 0}));
  EXPECT_EQ(problem.world_from_camera[2].translation().z(), 1.0);
  EXPECT_EQ(problem.prior.J0, window.prior.J0);
  EXPECT_EQ(problem.camera.fx, kCamera.fx);
  const FeatureNoise noise = {{}, 1.2};
  AddLandmark(window.landmarks[2], noise, problem);
  AddLandmark(window.landmarks[3], noise, problem);
  ASSERT_EQ(problem.points.size(), 2U);
  EXPECT_EQ(problem.points[1], Eigen::Vector3d(0.0, 0.0, 4.0));
  ASSERT_EQ(problem.factors.size(), 3U);
  const ReprojectionFactor& last = problem.factors[2];
  EXPECT_EQ(last.pose, 1);
  EXPECT_EQ(last.point, 1);
  EXPECT_EQ(last.z_px, Eigen::Vector3d(3.0, 4.0, 0.5));
  EXPECT_EQ(last.sqrt_information, noise.SqrtInformation(window.landmarks[3].observations[1]));
}

TEST(SelectLandmarks, RequiresTwoObservationsAndPrefersTheFirst) {
  const Window window = MakeWindow({0, 3, 8});
  EXPECT_EQ(SelectLandmarks(window, 3), (std::vector<int>{0, 3, 8}));
  EXPECT_EQ(SelectLandmarks(window, 2), (std::vector<int>{0, 3})) << "of equals the first";
  EXPECT_TRUE(SelectLandmarks(window, 0).empty());
}

}  // namespace
}  // namespace cvo::window_parts_test
