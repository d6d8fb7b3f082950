// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/collection.h"

namespace cvo {

// Runs the suites of a collection, each to a folder with its name below the output folder, and
// writes index.html there. Returns 0 if all jobs that can run have run; a suite without any
// sequence on this disk is not a failure. Throws Error as RunSuite.
int RunCollection(const Collection& collection, const SuiteRunFlags& flags);

}  // namespace cvo
