// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "experiments/cli/suite/suite_flags.h"

namespace cvo {

// What experiment run is asked for.
struct SuiteRunFlags {
  SuiteFlags suite;
  EngineFlags engine;
  double limit_s = 3600.0;          // of one job; 0: none
  double limit_memory_mb = 8000.0;  // of one job; 0: none
  bool quiet = false;
};

// Nothing of a suite is below --data. Its plan is written.
class NoSequence : public Error {
 public:
  using Error::Error;
};

// Renders, plans and runs a suite; the exit code. Throws Error for a suite that cannot be run and a
// folder that cannot be written, NoSequence.
int RunSuite(const SuiteRunFlags& flags);

}  // namespace cvo
