// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/estimation/double_track.h"
#include "core/estimation/window_problem.h"
#include "core/solvers/reprojection_cost.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::window_test {
namespace {

const StereoCamera kCamera = test::CentredCamera(500, 0.5, 640, 480);
constexpr int kFrames = 4;
constexpr int kPoints = 12;
constexpr int kRemoved = 1;

RigidTransform RandomPose(Rng& rng, double size) {
  const auto random = [&] {
    return Eigen::Vector3d(size * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal()));
  };
  return {ExpSo3(random()), random()};
}

// Returns a window with inconsistent observations, some of them beyond Huber's threshold. The
// linearisation point of the prior differs from the current poses.
WindowProblem MakeProblem(std::uint64_t seed) {
  Rng rng(seed, "marginalization");
  WindowProblem problem;
  problem.camera = kCamera;
  problem.camera.right_field_px << 0.3, -0.4, 0.2, 0.5, -0.1, 0.6;
  for (int i = 0; i < kFrames; ++i) {
    problem.frames.push_back(FrameId{10 + i});
    problem.world_from_camera.push_back(RandomPose(rng, 0.05));
  }
  problem.is_fixed.assign(kFrames, 0);
  for (int p = 0; p < kPoints; ++p) {
    problem.points.emplace_back(rng.Uniform(-3, 3), rng.Uniform(-2, 2), rng.Uniform(6, 12));
    for (int i = p % 3; i < kFrames; ++i) {
      const Eigen::Vector3d z =
          *problem.camera.Project(problem.world_from_camera[i].Inverse() * problem.points[p]);
      const Eigen::Vector3d off(2.0 * rng.Normal(), 2.0 * rng.Normal(), 2.0 * rng.Normal());
      problem.factors.push_back({i, p, z + off, Eigen::Vector3d(1.0, 0.8, 1.3).asDiagonal()});
    }
  }
  WindowPrior& prior = problem.prior;
  prior.frames = {problem.frames[0], problem.frames[1], problem.frames[3]};
  for (const int i : {0, 1, 3}) {
    prior.linearization_point.push_back(problem.world_from_camera[i] * RandomPose(rng, 0.3));
  }
  prior.right_field_point_px = Vector6d::Constant(0.1);
  prior.J0 = Eigen::MatrixXd::NullaryExpr(30, 24, [&] { return 20.0 * rng.Normal(); });
  prior.r0 = Eigen::VectorXd::NullaryExpr(30, [&] { return rng.Normal(); });
  return problem;
}

// Order of the unknowns: six per frame, six of the right field, three per point.
constexpr int kField = 6 * kFrames;
constexpr int kUnknowns = kField + 6 + 3 * kPoints;

// H and b of all unknowns, as one dense system.
struct Dense {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kUnknowns, kUnknowns);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(kUnknowns);

  void Add(const Eigen::MatrixXd& J, const Eigen::VectorXd& r, double weight) {
    H += weight * J.transpose() * J;
    b += weight * J.transpose() * r;
  }
};

Eigen::VectorXd PriorResidual(const WindowProblem& problem) {
  const WindowPrior& prior = problem.prior;
  Eigen::VectorXd dx(24);
  for (int k = 0; k < 3; ++k) {
    const int pose = std::array{0, 1, 3}[static_cast<std::size_t>(k)];
    dx.segment<6>(6 * k) = problem.world_from_camera[pose].Minus(prior.linearization_point[k]);
  }
  dx.tail<6>() = problem.camera.right_field_px - prior.right_field_point_px;
  return prior.r0 + prior.J0 * dx;
}

// Adds the prior, with its Jacobian by numeric differences in each unknown.
void AddPrior(const WindowProblem& problem, Dense& dense) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(30, kUnknowns);
  for (int k = 0; k < kField + 6; ++k) {
    const auto moved = [&](double step) {
      WindowProblem other = problem;
      if (k < kField) {
        RigidTransform& pose = other.world_from_camera[k / 6];
        pose = pose.Plus(step * Vector6d::Unit(k % 6));
      } else {
        other.camera.right_field_px[k - kField] += step;
      }
      return PriorResidual(other);
    };
    J.col(k) = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
  }
  dense.Add(J, PriorResidual(problem), 1.0);
}

Dense AllTogether(const WindowProblem& problem, const NoiseOptions& noise) {
  Dense dense;
  for (const ReprojectionFactor& factor : problem.factors) {
    const ReprojectionResidual value =
        EvaluateReprojection(problem.camera, factor.z_px, factor.sqrt_information,
                             problem.world_from_camera[factor.pose], problem.points[factor.point]);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, kUnknowns);
    J.middleCols<6>(6 * factor.pose) = value.J_pose;
    J.middleCols<6>(kField) = value.J_field;
    J.middleCols<3>(kField + 6 + 3 * factor.point) = value.J_point;
    dense.Add(J, value.r, HuberWeight(value.r.squaredNorm(), noise.huber));
  }
  AddPrior(problem, dense);
  return dense;
}

// The prior must equal the Schur complement computed from the dense system.
TEST(Marginalize, EqualsTheDenseSchurComplement) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const WindowProblem problem = MakeProblem(seed);
    const Dense dense = AllTogether(problem, {});
    std::vector<int> kept;
    std::vector<int> gone;
    for (int k = 0; k < kUnknowns; ++k) {
      (k / 6 == kRemoved || k >= kField + 6 ? gone : kept).push_back(k);
    }
    const Eigen::MatrixXd left =
        dense.H(kept, gone) * Eigen::MatrixXd(dense.H(gone, gone)).inverse();
    const Eigen::MatrixXd H = dense.H(kept, kept) - left * dense.H(gone, kept);
    const Eigen::VectorXd b = dense.b(kept) - left * dense.b(gone);
    const WindowPrior prior = Marginalize({}, problem, problem.frames[kRemoved]);
    ASSERT_EQ(prior.J0.cols(), H.cols());
    EXPECT_LT((prior.J0.transpose() * prior.J0 - H).norm() / H.norm(), 1e-7);
    EXPECT_LT((prior.J0.transpose() * prior.r0 - b).norm() / b.norm(), 1e-7);
    EXPECT_EQ(prior.frames, (std::vector<FrameId>{FrameId{10}, FrameId{12}, FrameId{13}}));
    EXPECT_EQ(prior.right_field_point_px, problem.camera.right_field_px);
    for (int i = 0; i < 3; ++i) {
      const RigidTransform& now = problem.world_from_camera[std::array{0, 2, 3}[i]];
      EXPECT_EQ(prior.linearization_point[i].Minus(now).norm(), 0.0);
    }
  }
}

// Returns a window of frames 10 and 11 whose only information is a prior with the given rows.
WindowProblem PriorAlone(const Eigen::MatrixXd& J0) {
  WindowProblem problem;
  problem.camera = kCamera;
  problem.frames = {FrameId{10}, FrameId{11}};
  problem.world_from_camera.resize(2);
  problem.is_fixed.assign(2, 0);
  problem.prior.frames = problem.frames;
  problem.prior.linearization_point = problem.world_from_camera;
  problem.prior.J0 = J0;
  problem.prior.r0 = Eigen::VectorXd::Zero(J0.rows());
  return problem;
}

TEST(Marginalize, DropsDirectionsBelowTenToTheMinusTenOfTheLargest) {
  Eigen::VectorXd information = Eigen::VectorXd::Ones(18);
  information[7] = 3e-11;
  information[8] = 3e-10;
  for (const double scale : {1.0, 100.0}) {
    const Eigen::MatrixXd J0 = (scale * information).cwiseSqrt().asDiagonal();
    const WindowPrior prior = Marginalize({}, PriorAlone(J0), FrameId{10});
    EXPECT_EQ(prior.J0.rows(), 11);
    EXPECT_NEAR(prior.J0.col(2).squaredNorm() / (3e-10 * scale), 1.0, 1e-3);
    EXPECT_NEAR(prior.J0.col(0).squaredNorm() / scale, 1.0, 1e-12);
  }
}

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

const SolverOptions kToConvergence = {.iterations = 60, .function_tolerance = 1e-14};

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
  const Vector6d deviation_px = CalibrationDeviation({.right_mean_px = 0.2, .right_field_px = 0.0});
  problem.prior = CalibrationPrior(kCamera, deviation_px);
  const SolverSummary summary = SolveWindow({}, kToConvergence, problem);
  const Vector6d sigma_px = summary.shared_information.inverse().diagonal().cwiseSqrt();
  EXPECT_LT(sigma_px[0], 0.2) << "the points say something of the mean";
  EXPECT_NEAR(sigma_px[3] / deviation_px[3], 1.0, 1e-3);
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
  const DoubleTrack<DoubleTrackFrames> track(options, {{}, 1.2});
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

}  // namespace
}  // namespace cvo::window_test
