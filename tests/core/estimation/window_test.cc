// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/estimation/double_track.h"
#include "core/estimation/marginalization.h"
#include "core/estimation/window_problem.h"
#include "tests/support/centred_camera.h"

namespace cvo::window_test {
namespace {

const StereoCamera kCamera = test::CentredCamera(500, 0.5, 640, 480);

RigidTransform CameraAt(int frame) {
  return {ExpSo3({0.0, 0.01 * frame, 0.0}), Eigen::Vector3d(0.05 * frame, 0.0, 0.4 * frame)};
}

// Returns a problem at its true state. Every frame observes every point, with noise.
WindowProblem MakeProblem(int frames, int points, double noise_px, Rng& rng) {
  WindowProblem problem;
  problem.camera = kCamera;
  problem.prior = CalibrationPrior(kCamera, Vector6d::Ones());
  problem.is_right_field_fixed = true;
  for (int i = 0; i < frames; ++i) {
    problem.frames.push_back(FrameId{10 + i});
    problem.world_from_camera.push_back(CameraAt(i));
  }
  problem.is_fixed.assign(problem.frames.size(), 0);
  problem.is_fixed[0] = 1;
  for (int p = 0; p < points; ++p) {
    problem.points.emplace_back(rng.Uniform(-3, 3), rng.Uniform(-2, 2), rng.Uniform(6, 12));
    for (int i = 0; i < frames; ++i) {
      const auto z = kCamera.Project(problem.world_from_camera[i].Inverse() * problem.points[p]);
      const Eigen::Vector3d noise(rng.Normal(), rng.Normal(), rng.Normal());
      problem.factors.push_back({i, p, *z + noise_px * noise, Eigen::Matrix3d::Identity()});
    }
  }
  return problem;
}

void Disturb(WindowProblem& problem, double size, Rng& rng) {
  for (std::size_t i = 1; i < problem.frames.size(); ++i) {
    const Vector6d step = Vector6d::NullaryExpr([&] { return size * rng.Normal(); });
    problem.world_from_camera[i] = problem.world_from_camera[i].Plus(step);
  }
  for (Eigen::Vector3d& point : problem.points) {
    point += size * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
  }
}

const SolverOptions kToConvergence = {.iterations = 60, .function_tolerance = 1e-14};

TEST(SolveWindow, ReturnsToTheTruth) {
  Rng rng(1, "window");
  WindowProblem problem = MakeProblem(5, 60, 0.0, rng);
  const WindowProblem truth = problem;
  Disturb(problem, 0.02, rng);
  SolveWindow({}, kToConvergence, problem);
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    EXPECT_LT(problem.world_from_camera[i].Minus(truth.world_from_camera[i]).norm(), 1e-6);
  }
}

TEST(SolveWindow, RecoversTheRightField) {
  Rng rng(2, "window");
  WindowProblem problem = MakeProblem(6, 150, 0.0, rng);
  StereoCamera truth = kCamera;
  truth.right_field_px << 0.3, -0.4, 0.2, 0.5, -0.1, 0.6;
  for (ReprojectionFactor& factor : problem.factors) {
    factor.z_px[2] += truth.RightShift(factor.z_px[0], factor.z_px[1]);
  }
  problem.is_right_field_fixed = false;
  problem.prior = CalibrationPrior(kCamera, Vector6d::Constant(100.0));
  SolveWindow({}, kToConvergence, problem);
  EXPECT_LT((problem.camera.right_field_px - truth.right_field_px).norm(), 2e-3);
  EXPECT_LT(problem.world_from_camera.back().Minus(CameraAt(5)).norm(), 1e-3);
}

TEST(SolveWindow, UnobservedFieldKeepsItsPriorDeviation) {
  Rng rng(12, "window");
  WindowProblem problem = MakeProblem(3, 20, 0.1, rng);
  problem.is_right_field_fixed = false;
  const Vector6d deviation_px = EstimateRightShift::Deviation({.right_mean_px = 0.2});
  problem.prior = CalibrationPrior(kCamera, deviation_px);
  const SolverSummary summary = SolveWindow({}, kToConvergence, problem);
  const Vector6d sigma_px = summary.shared_information.inverse().diagonal().cwiseSqrt();
  EXPECT_LT(sigma_px[0], 0.2) << "the points say something of the mean";
  EXPECT_NEAR(sigma_px[3] / deviation_px[3], 1.0, 1e-3);
}

TEST(SolveWindow, RefusesAPriorOnAnUnknownFrame) {
  Rng rng(3, "window");
  WindowProblem problem = MakeProblem(2, 10, 0.0, rng);
  problem.prior.frames = {FrameId{99}};
  problem.prior.linearization_point = {RigidTransform()};
  problem.prior.J0 = Eigen::MatrixXd::Zero(1, 12);
  EXPECT_THROW(SolveWindow({}, kToConvergence, problem), Error);
}

// Compares the solution of the full window with that of the window in which a frame and points are
// replaced by their prior.
TEST(Marginalize, PreservesTheOptimumOfTheRemainingStates) {
  Rng rng(4, "window");
  WindowProblem batch = MakeProblem(5, 60, 0.3, rng);
  batch.is_fixed.assign(5, 0);
  batch.is_fixed[4] = 1;
  SolveWindow({}, kToConvergence, batch);

  // Frame 10 and points 0 to 29 are marginalised; the frame has no observations of other points.
  std::erase_if(batch.factors, [](const auto& f) { return f.point >= 30 && f.pose == 0; });
  SolveWindow({}, kToConvergence, batch);
  WindowProblem removed = batch;
  std::erase_if(removed.factors, [](const auto& f) { return f.point >= 30; });
  WindowProblem rest = batch;
  rest.prior = Marginalize({}, removed, FrameId{10});
  std::erase_if(rest.factors, [](const auto& f) { return f.point < 30; });
  for (ReprojectionFactor& factor : rest.factors) {
    factor.point -= 30;
    factor.pose -= 1;
  }
  rest.points.erase(rest.points.begin(), rest.points.begin() + 30);
  rest.frames.erase(rest.frames.begin());
  rest.world_from_camera.erase(rest.world_from_camera.begin());
  rest.is_fixed.erase(rest.is_fixed.begin());
  const WindowProblem before = rest;
  Disturb(rest, 1e-4, rng);
  rest.world_from_camera[3] = before.world_from_camera[3];
  SolveWindow({}, kToConvergence, rest);
  for (int i = 0; i < 4; ++i) {
    EXPECT_LT(rest.world_from_camera[i].Minus(batch.world_from_camera[i + 1]).norm(), 2e-6);
  }
}

TEST(Marginalize, PriorOfAFreeWindowHasSixNullDirections) {
  Rng rng(5, "window");
  const WindowProblem problem = MakeProblem(4, 40, 0.2, rng);
  const WindowPrior prior = Marginalize({}, problem, FrameId{10});
  ASSERT_EQ(prior.frames.size(), 3u);
  EXPECT_EQ(prior.J0.cols(), 6 * 3 + 6);
  const Eigen::MatrixXd H = prior.J0.transpose() * prior.J0;
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues();
  EXPECT_EQ((values.array() < 1e-8 * values.maxCoeff()).count(), 6);
}

TEST(Marginalize, IncludesOnlyFramesWithObservations) {
  Rng rng(6, "window");
  WindowProblem problem = MakeProblem(4, 20, 0.2, rng);
  std::erase_if(problem.factors, [](const auto& f) { return f.pose == 2; });
  const WindowPrior prior = Marginalize({}, problem, FrameId{10});
  EXPECT_EQ(prior.frames, (std::vector<FrameId>{FrameId{11}, FrameId{13}}));
}

// Returns a window in which landmark k is observed in the frames seen[k].
Window MakeWindow(const std::vector<std::vector<int>>& seen) {
  Window window{kCamera, CalibrationPrior(kCamera, Vector6d::Ones()), {}, {}, {}};
  for (std::size_t k = 0; k < seen.size(); ++k) {
    Landmark landmark;
    landmark.id = LandmarkId{static_cast<std::int64_t>(k)};
    landmark.p_in_object = {0.1 * static_cast<double>(k), 0.2, 10.0};
    for (const int frame : seen[k]) {
      const auto z = kCamera.Project(CameraAt(frame).Inverse() * landmark.p_in_object);
      landmark.observations.push_back({FrameId{frame}, *z, 0});
      landmark.last_seen = FrameId{frame};
    }
    window.landmarks.push_back(landmark);
  }
  return window;
}

// Frames 0, 4, ... 20 pass through tracks of two and three frames, so that frame 0 leaves when
// frame 20 enters.
TEST(DoubleTrack, MarginalisesLandmarksNotSeenInTheNewestFrame) {
  const std::vector<int> all = {0, 4, 8, 12, 16, 20};
  Window window = MakeWindow({all, {0, 4, 8}, {0, 4}, all, {0}});
  for (int i = 0; i < 5; ++i) {
    const WindowFrame frame = {FrameId{4 * i}, CameraAt(4 * i)};
    (i < 2 ? window.spatial : window.temporal).push_back(frame);
  }
  const WindowOptions options = {.spatial = 2, .temporal = 3};
  const DoubleTrack<MarginalizeUnseenByNewest, PromoteDistant> track(options, {{}, 1.2});
  track.Advance({FrameId{20}, CameraAt(20)}, window);

  ASSERT_EQ(window.spatial.size(), 2u);
  EXPECT_EQ(window.spatial[0].id, FrameId{4});
  EXPECT_EQ(window.spatial[1].id, FrameId{8});
  ASSERT_EQ(window.temporal.size(), 3u);
  EXPECT_EQ(window.temporal[2].id, FrameId{20});
  EXPECT_EQ(window.prior.frames, (std::vector<FrameId>{FrameId{4}, FrameId{8}}));
  // Landmarks 1 and 2 are in the prior; 4 was observed in frame 0 only; of 0 and 3 the observation
  // in frame 0 is deleted.
  ASSERT_EQ(window.landmarks.size(), 2u);
  EXPECT_EQ(window.landmarks[0].id, LandmarkId{0});
  EXPECT_EQ(window.landmarks[1].id, LandmarkId{3});
  EXPECT_EQ(window.landmarks[0].observations.size(), 5u);
}

TEST(DoubleTrack, KeepsNoPriorIfNothingIsMarginalised) {
  Window window = MakeWindow({{0, 4, 8}, {0, 4}});
  window.spatial = {{FrameId{0}, CameraAt(0)}, {FrameId{4}, CameraAt(4)}};
  window.temporal = {{FrameId{8}, CameraAt(8)}};
  const WindowOptions options = {.spatial = 2, .temporal = 1};
  const DoubleTrack<MarginalizeNothing, PromoteDistant> track(options, {{}, 1.2});
  track.Advance({FrameId{12}, CameraAt(12)}, window);
  EXPECT_EQ(window.spatial[0].id, FrameId{4});
  EXPECT_TRUE(window.prior.frames.empty());
  EXPECT_EQ(window.landmarks.size(), 2u);
}

TEST(DoubleTrack, DiscardsEverythingWithoutASpatialTrack) {
  const WindowOptions options = {.spatial = 2, .temporal = 3};
  const DoubleTrack<MarginalizeUnseenByNewest, PromoteNever> track(options, {{}, 1.2});
  Window window = MakeWindow({});
  for (int i = 0; i < 8; ++i) track.Advance({FrameId{i}, CameraAt(i)}, window);
  EXPECT_TRUE(window.spatial.empty());
  EXPECT_EQ(window.temporal.front().id, FrameId{5});
  EXPECT_TRUE(window.prior.frames.empty());
}

TEST(SelectLandmarks, PrefersLandmarksWithMoreObservations) {
  const Window window = MakeWindow({{0}, {0, 1}, {0, 1, 2}, {1, 2}, {0, 1, 2, 3}});
  EXPECT_EQ(SelectLandmarks(window, 10), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(SelectLandmarks(window, 2), (std::vector<int>{2, 4}));
}

}  // namespace
}  // namespace cvo::window_test
