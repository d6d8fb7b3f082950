// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/gate/gate_report.h"

namespace cvo::reports {

// Compares the runs in a suite's output folder with a baseline. Throws Error only if the folder has
// no readable plan; everything else is in the report: jobs that are missing, failed or lost,
// metrics that are missing or have another contract, and nothing to compare. With `exact`, any
// difference also counts if the baseline is of the same platform; otherwise a note says that it is
// not.
GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline,
                     bool exact = false);

// The gate's report on a variant that was checked in place of the baseline's.
struct LostPart {
  std::string variant;
  GateReport report;
};

// Compares each variant of the folder with the baseline's runs of `variant`: what the gate would
// report if the estimator lost the parts that those variants lack. Throws Error as CheckRuns does,
// and if the baseline has no runs of `variant`.
std::vector<LostPart> CheckInPlaceOf(const std::string& variant,
                                     const std::filesystem::path& folder, const Baseline& baseline,
                                     bool exact = false);

}  // namespace cvo::reports
