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

// Flags that select a suite, its data and its output folder.
struct SuiteFlags {
  std::string suite;
  std::string output;
  std::string data;
  SuiteOverrides overrides;

  void AddTo(CLI::App& app);
  // Throws Error for an invalid suite.
  Suite Load() const;
  // Sets the data folder, which is --data, else CLUSTERVO_DATA, else empty, and the cache folder.
  PlanRequest Request() const;
};

// Flags that select where jobs run.
struct EngineFlags {
  std::string name = "local";
  int jobs = 0;  // in parallel; 0: not specified
  std::vector<std::string> sbatch;

  void AddTo(CLI::App& app);
  // Throws Error for flags that do not apply to the engine.
  std::unique_ptr<Engine> Make(const SuiteFolder& folder) const;
};

}  // namespace cvo
