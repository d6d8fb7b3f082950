// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/runs/run_comparison.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {

// Where the camera was estimated and where it was, in frames that have both.
struct CameraPositions {
  std::vector<int> frames;  // ascending
  std::vector<Position> estimated_m;
  std::vector<Position> truth_m;
};

// A run as it is compared.
struct RunToCompare {
  std::string name;
  RunSummary summary;
  CameraPositions camera;  // may be empty
};

CameraPositions CameraPositionsOf(const RunDetail& detail);

// The camera and each body that both estimate, over the frames of both. The camera's positions are
// aligned to the truth over these frames, as camera ATE aligns them over all of a run's; those of
// bodies are in the world that their metrics are taken in.
std::vector<PairedComparison> PairByFrame(const RunToCompare& run, const RunToCompare& reference);

// Metrics of bodies, over the bodies of both.
std::vector<PairedComparison> PairByBody(const RunToCompare& run, const RunToCompare& reference,
                                         const std::vector<ComparedMetric>& metrics);

}  // namespace cvo::reports
