// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "experiments/suite/build_plan.h"
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

}  // namespace cvo
