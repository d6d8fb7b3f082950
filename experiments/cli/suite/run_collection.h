// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/collection.h"

namespace cvo {

// Runs the suites of a collection, each to a folder of its name below the output folder, and writes
// index.html there. The exit code is 0 where all that can run has run: a suite without any sequence
// on this disk is no failure. Throws Error as RunSuite.
int RunCollection(const Collection& collection, const SuiteRunFlags& flags);

}  // namespace cvo
