// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "experiments/jobs/engine.h"
#include "experiments/jobs/suite_folder.h"
#include "experiments/suite/plan/build_plan.h"
#include "experiments/suite/suite_overrides.h"

namespace cvo {

// The flags that say which suite is meant, where its data are and where its results go.
struct SuiteFlags {
  std::string suite;
  std::string output;
  std::string data;
  SuiteOverrides overrides;

  void AddTo(CLI::App& app);
  // Throws Error for a suite that cannot be.
  Suite Load() const;
  // --data, else CLUSTERVO_DATA, else empty; and the cache.
  PlanRequest Request() const;
};

// The flags that say where jobs run.
struct EngineFlags {
  std::string name = "local";
  int jobs = 0;  // at once; 0: not said
  std::vector<std::string> sbatch;

  void AddTo(CLI::App& app);
  // Throws Error for flags that do not fit the engine.
  std::unique_ptr<Engine> Make(const SuiteFolder& folder) const;
};

}  // namespace cvo
