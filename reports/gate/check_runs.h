// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/gate/gate_report.h"

namespace cvo::reports {

// Holds the runs of a folder that a suite was run to against a baseline. Throws Error only where
// the folder has no plan that can be read; all else is in the report: jobs that are missing, failed
// or lost, metrics that are missing or mean something else, and nothing to compare. Exact: counts
// what differs at all, too, if the baseline is of the same platform; else a note says that it is
// not.
GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline,
                     bool exact = false);

// How the gate sees a variant that is not the baseline's.
struct LostPart {
  std::string variant;
  GateReport report;
};

// Holds each variant of the folder against the baseline's runs of `variant`: what the gate would
// say if the estimator lost what they lack. Throws Error as CheckRuns, and where the baseline has
// no such runs.
std::vector<LostPart> CheckInPlaceOf(const std::string& variant,
                                     const std::filesystem::path& folder, const Baseline& baseline,
                                     bool exact = false);

}  // namespace cvo::reports
