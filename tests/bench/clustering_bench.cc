// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/point_extent.h"
#include "core/clustering/unary_terms.h"

namespace cvo {
namespace {

struct Problem {
  CrfMatrix energies;
  Eigen::Matrix3Xd points;
};

// Returns nodes at random positions in a cube of side size_m, with random energies.
Problem Room(int nodes, int labels, double size_m) {
  Rng rng(1, "bench");
  Problem problem{CrfMatrix(nodes, labels), Eigen::Matrix3Xd(3, nodes)};
  for (double& value : problem.points.reshaped()) value = rng.Uniform(0.0, size_m);
  for (double& value : problem.energies.reshaped()) value = rng.Uniform(0.0, 6.0);
  return problem;
}

void BM_DenseCrf(benchmark::State& state) {
  const Problem problem = Room(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                               static_cast<double>(state.range(2)));
  PairwiseOptions options;
  options.tolerance = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        InferDenseCrf<NormalizedGaussianKernel>(problem.energies, problem.points, options).sweeps);
  }
}
// A room of 4 m, where no pair is cut off, and a street of 40 m.
BENCHMARK(BM_DenseCrf)
    ->ArgNames({"nodes", "labels", "size_m"})
    ->Args({300, 8, 4})
    ->Args({1000, 8, 4})
    ->Args({1000, 8, 40})
    ->Args({1000, 3, 4})
    ->Args({1000, 64, 4})
    ->Args({2000, 8, 4})
    ->Args({4000, 8, 4})
    ->Args({1000, 500, 4})
    ->Unit(benchmark::kMillisecond);

void BM_DenseCrfPlain(benchmark::State& state) {
  const Problem problem = Room(static_cast<int>(state.range(0)), 8, 4.0);
  PairwiseOptions options;
  options.tolerance = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        InferDenseCrfPlain<NormalizedGaussianKernel>(problem.energies, problem.points, options)
            .sweeps);
  }
}
BENCHMARK(BM_DenseCrfPlain)->ArgName("nodes")->Arg(1000)->Unit(benchmark::kMillisecond);

const StereoCamera kCamera = {.fx = 700,
                              .fy = 700,
                              .cx = 600,
                              .cy = 180,
                              .baseline_m = 0.54,
                              .width_px = 1242,
                              .height_px = 375};

CrfLabel BodyLabel(Rng& rng) {
  CrfLabel label;
  label.kind = LabelKind::kCluster;
  const double left = rng.Uniform(0, 1000);
  const double top = rng.Uniform(0, 200);
  label.box = ImageBox{left, top, left + 150, top + 120};
  label.extent = CrfLabel::Extent{.center_in_camera = {rng.Uniform(-5, 5), 0.0, 15.0}};
  label.past_from_now = {RigidTransform(ExpSo3({0.0, 0.05 * rng.Normal(), 0.0}),
                                        Eigen::Vector3d(rng.Normal(), 0.0, rng.Normal()))};
  return label;
}

CrfNode RandomNode(Rng& rng) {
  const Eigen::Matrix3d covariance_px2 = 0.5 * Eigen::Matrix3d::Identity();
  CrfNode node;
  const double u = rng.Uniform(0, 1241);
  node.z_px = {u, rng.Uniform(0, 374), u - rng.Uniform(5, 60)};
  node.p_in_camera = *kCamera.BackProject(node.z_px);
  node.covariance_m2 = kCamera.PointCovariance(node.z_px, covariance_px2);
  node.past = CrfNode::Past{.z_px = node.z_px, .covariance_px2 = covariance_px2};
  return node;
}

CrfScene RandomScene(int nodes, int labels) {
  Rng rng(1, "unary_bench");
  CrfScene scene;
  scene.camera = kCamera;
  for (int l = 0; l < labels; ++l) scene.labels.push_back(BodyLabel(rng));
  scene.labels.front() = CrfLabel();
  scene.labels.front().past_from_now = {RigidTransform()};
  scene.labels.back() = CrfLabel();
  scene.labels.back().kind = LabelKind::kOutlier;
  for (int i = 0; i < nodes; ++i) scene.nodes.push_back(RandomNode(rng));
  return scene;
}

// Arguments: number of landmarks, number of labels. This is the worst case: every landmark has a
// past observation and every body a pose in that frame.
void BM_Unaries(benchmark::State& state) {
  const CrfScene scene =
      RandomScene(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(ComputeUnaries<Box2dTerm, AffinityTerm, MotionTerm>(scene, {}));
  }
}
BENCHMARK(BM_Unaries)->Args({1200, 3})->Args({1200, 8})->Unit(benchmark::kMicrosecond);

template <typename Term>
void BM_Term(benchmark::State& state) {
  const CrfScene scene = RandomScene(1200, 8);
  for (auto _ : state) benchmark::DoNotOptimize(TermEnergies<Term>(scene, {}));
}
BENCHMARK(BM_Term<Box2dTerm>)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Term<AffinityTerm>)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Term<MotionTerm>)->Unit(benchmark::kMicrosecond);

void BM_DepthModes(benchmark::State& state) {
  Rng rng(1, "unary_bench");
  std::vector<double> depths_m(static_cast<std::size_t>(state.range(0)));
  for (double& depth_m : depths_m) depth_m = rng.Uniform(5.0, 80.0);
  for (auto _ : state) benchmark::DoNotOptimize(DepthModes(depths_m, 0.15, {}));
}
BENCHMARK(BM_DepthModes)->Arg(200)->Unit(benchmark::kMicrosecond);

void BM_ExtentAndAxes(benchmark::State& state) {
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, state.range(0));
  for (auto _ : state) {
    const RigidTransform frame = PrincipalAxes(points, {});
    benchmark::DoNotOptimize(ExtentAlong(frame.RotationMatrix(), points, {}));
  }
}
BENCHMARK(BM_ExtentAndAxes)->Arg(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cvo
