// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/base/task_pool.h"

namespace cvo {
namespace {

void BM_RngNormal(benchmark::State& state) {
  Rng rng(1, "bench");
  for (auto _ : state) benchmark::DoNotOptimize(rng.Normal());
}
BENCHMARK(BM_RngNormal);

// Overhead of submitting a task and waiting for it; smaller tasks are not worth submitting.
void BM_TaskPoolRoundTrip(benchmark::State& state) {
  TaskPool pool(static_cast<int>(state.range(0)));
  for (auto _ : state) pool.Wait(pool.Submit([] {}));
}
BENCHMARK(BM_TaskPoolRoundTrip)->Arg(1)->Arg(2)->UseRealTime();

}  // namespace
}  // namespace cvo
