// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/pictures/run_images.h"
#include "reports/runs/body_story.h"

namespace cvo {

// A body in a run with a part of the truth given.
struct OracleResult {
  std::string oracle;  // "true boxes"
  int judged = 0;
  int estimated = 0;
  int good = 0;  // within reports::kGoodError_m
  std::optional<double> ate_m;
};

OracleResult ResultOf(const std::string& oracle, const reports::BodyDetail& body);

// Runs the sequence again as `run_folder` says, with each of boxes, labels and camera given. Empty
// where it was stopped. Throws Error for a run that cannot be repeated.
std::optional<std::vector<OracleResult>> TryOracles(const std::string& run_folder,
                                                    const Sequence& sequence, int body, int threads,
                                                    bool quiet);

}  // namespace cvo
