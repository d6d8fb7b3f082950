// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/pictures/run_images.h"
#include "reports/runs/body_story.h"

namespace cvo {

// Result for one body of a run that was given a part of the ground truth.
struct OracleResult {
  std::string oracle;  // "true boxes"
  int judged = 0;
  int estimated = 0;
  int good = 0;  // error of at most reports::kGoodError_m
  std::optional<double> ate_m;
};

OracleResult ResultOf(const std::string& oracle, const reports::BodyDetail& body);

// Repeats the run in `run_folder` with true boxes, with true labels and with the true camera.
// Returns the results for the body, one per repetition, or nothing if stopped. Throws Error for a
// run that cannot be repeated.
std::optional<std::vector<OracleResult>> TryOracles(const std::string& run_folder,
                                                    const Sequence& sequence, int body, int threads,
                                                    bool quiet);

}  // namespace cvo
