// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/runs/run_comparison.h"
#include "reports/runs/run_detail.h"
#include "reports/statistics/common_frames.h"

namespace cvo::reports {

// A run as it is compared.
struct RunToCompare {
  std::string name;
  RunSummary summary;
  FrameErrors camera;  // positions against the truth in the world of the run; may be empty
};

FrameErrors CameraErrors(const RunDetail& detail);

// The camera and each body that both estimate, over the frames of both.
std::vector<PairedComparison> PairByFrame(const RunToCompare& run, const RunToCompare& reference);

// Metrics of bodies, over the bodies of both.
std::vector<PairedComparison> PairByBody(const RunToCompare& run, const RunToCompare& reference,
                                         const std::vector<ComparedMetric>& metrics);

}  // namespace cvo::reports
