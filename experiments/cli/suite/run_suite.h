// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "experiments/cli/suite/suite_flags.h"

namespace cvo {

// Flags of clustervo experiment run.
struct SuiteRunFlags {
  SuiteFlags suite;
  EngineFlags engine;
  double limit_s = 3600.0;          // wall time of one job; 0: unlimited
  double limit_memory_mb = 8000.0;  // address space of one job; 0: unlimited
  bool quiet = false;
};

// None of the suite's sequences is below --data. The plan has been written.
class NoSequence : public Error {
 public:
  using Error::Error;
};

// Renders, plans and runs a suite. Returns the exit code. Throws Error for an invalid suite or a
// folder that cannot be written, and NoSequence.
int RunSuite(const SuiteRunFlags& flags);

}  // namespace cvo
