// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/clustering/dense_crf.h"

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

}  // namespace
}  // namespace cvo
