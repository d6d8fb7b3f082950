// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/estimation/camera_solver.h"
#include "core/estimation/window_problem.h"
#include "core/solvers/schur_solver.h"
#include "tests/support/feature_world.h"
#include "variants/registry.h"

namespace cvo {
namespace {

const StereoCamera kCamera = {.fx = 721.5,
                              .fy = 721.5,
                              .cx = 609.6,
                              .cy = 172.9,
                              .baseline_m = 0.537,
                              .width_px = 1242,
                              .height_px = 375};

// A window typical of KITTI: 20 frames, each point observed in five consecutive ones.
WindowProblem DrivingProblem(int points) {
  Rng rng(1, "bench");
  WindowProblem problem;
  problem.camera = kCamera;
  problem.prior = CalibrationPrior(kCamera, Vector6d::Constant(0.3));
  problem.is_right_field_fixed = true;
  for (int i = 0; i < 20; ++i) {
    problem.frames.push_back(FrameId{i});
    problem.world_from_camera.emplace_back(Eigen::Quaterniond::Identity(),
                                           Eigen::Vector3d(0.0, 0.0, i));
  }
  problem.is_fixed.assign(20, 0);
  problem.is_fixed[0] = 1;
  for (int p = 0; p < points; ++p) {
    const int first = static_cast<int>(rng.UniformInt(16));
    problem.points.emplace_back(rng.Uniform(-8, 8), rng.Uniform(-2, 2),
                                first + rng.Uniform(12, 40));
    for (int i = first; i < first + 5; ++i) {
      const Eigen::Vector3d z =
          *kCamera.Project(problem.world_from_camera[i].Inverse() * problem.points[p]) +
          0.5 * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
      problem.factors.push_back({i, p, z, SqrtInformation({}, 1.0)});
    }
    problem.points[p] *= 1.01;
  }
  return problem;
}

void BM_SolveCamera(benchmark::State& state) {
  const WindowProblem problem = DrivingProblem(600);
  std::vector<PointMeasurement> measurements;
  for (const ReprojectionFactor& factor : problem.factors) {
    if (factor.pose == 10) {
      measurements.push_back({problem.points[factor.point], factor.z_px, factor.sqrt_information});
    }
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(SolveCamera(kCamera, measurements, problem.world_from_camera[9], {}));
  }
  state.counters["measurements"] = static_cast<double>(measurements.size());
}
BENCHMARK(BM_SolveCamera)->Unit(benchmark::kMillisecond);

void BM_SolveWindow(benchmark::State& state) {
  const WindowProblem problem = DrivingProblem(static_cast<int>(state.range(0)));
  SolverSummary summary;
  for (auto _ : state) {
    WindowProblem copy = problem;
    summary = SolveWindow({}, {}, copy);
  }
  state.counters["steps"] = summary.iterations;
  state.counters["cost"] = summary.final_cost;
}
BENCHMARK(BM_SolveWindow)->Arg(600)->Arg(3000)->Unit(benchmark::kMillisecond);

// A car ahead with 60 points, observed in 15 frames; each frame shows three quarters of the points.
ClusterProblem CarProblem() {
  Rng rng(2, "bench");
  ClusterProblem problem;
  problem.camera = kCamera;
  for (int i = 0; i < 15; ++i) {
    problem.time_s.push_back(0.1 * i);
    problem.world_from_camera.emplace_back(Eigen::Quaterniond::Identity(),
                                           Eigen::Vector3d(0.0, 0.0, i));
    problem.world_from_object.emplace_back(ExpSo3({0.0, 0.01 * i, 0.0}),
                                           Eigen::Vector3d(-2.0, 1.0, 15.0 + 1.1 * i));
    problem.velocity_m_s.emplace_back(0.0, 0.0, 10.0);
  }
  problem.point_priors.resize(60);
  for (int p = 0; p < 60; ++p) {
    const Eigen::Vector3d point(rng.Uniform(-0.8, 0.8), rng.Uniform(-0.7, 0.7), rng.Uniform(-2, 2));
    problem.points.push_back(point + Eigen::Vector3d(0.0, 0.0, 0.2 * rng.Normal()));
    for (int i = 0; i < 15; ++i) {
      if (rng.UniformInt(4) == 0) continue;
      const Eigen::Vector3d z = *kCamera.Project(problem.world_from_camera[i].Inverse() *
                                                 (problem.world_from_object[i] * point)) +
                                0.5 * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
      problem.factors.push_back({i, p, z, SqrtInformation({}, 1.0)});
    }
  }
  return problem;
}

void BM_SolveCluster(benchmark::State& state) {
  const ClusterProblem problem = CarProblem();
  SolverSummary summary;
  for (auto _ : state) {
    ClusterProblem copy = problem;
    summary = SolveCluster<WhiteNoiseOnAcceleration>({}, {}, {}, copy);
  }
  state.counters["steps"] = summary.iterations;
}
BENCHMARK(BM_SolveCluster)->Unit(benchmark::kMillisecond);

void BM_Marginalize(benchmark::State& state) {
  WindowProblem problem = DrivingProblem(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(Marginalize({}, problem, FrameId{0}).r0.size());
  }
}
BENCHMARK(BM_Marginalize)->Arg(200)->Unit(benchmark::kMillisecond);

// The estimator without the front end: 500 features per frame.
void BM_WholeFrame(benchmark::State& state) {
  test::FeatureWorld world(7);
  TaskPool pool(1);
  StageTimes times;
  auto odometry = FindVariant("static").make({world.camera(), Options(), 0}, pool);
  int frame = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (frame == 100) {
      odometry = FindVariant("static").make({world.camera(), Options(), 0}, pool);
      frame = 0;
    }
    const StereoFrame seen =
        world.Observe(test::FeatureWorld::CameraAt(frame), frame * 100'000'000LL, 0.5);
    ++frame;
    state.ResumeTiming();
    benchmark::DoNotOptimize(odometry->Process(seen, times).inliers);
  }
}
BENCHMARK(BM_WholeFrame)->Unit(benchmark::kMillisecond)->Iterations(100);

}  // namespace
}  // namespace cvo
