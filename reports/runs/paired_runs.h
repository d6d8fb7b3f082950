// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/runs/run_comparison.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {

// Estimated and true positions of the camera, in frames that have both.
struct CameraPositions {
  std::vector<int> frames;  // ascending
  std::vector<Position> estimated_m;
  std::vector<Position> truth_m;
};

// A run to be compared.
struct RunToCompare {
  std::string name;
  RunSummary summary;
  CameraPositions camera;  // may be empty
};

CameraPositions CameraPositionsOf(const RunDetail& detail);

// Compares the camera and each body that both runs estimate, over the frames of both. The camera's
// positions are aligned to the truth over these frames, as camera ATE aligns them over all frames
// of a run; those of bodies are in the world frame in which their metrics are computed.
std::vector<PairedComparison> PairByFrame(const RunToCompare& run, const RunToCompare& reference);

// Compares metrics of bodies, over the bodies that both runs have.
std::vector<PairedComparison> PairByBody(const RunToCompare& run, const RunToCompare& reference,
                                         const std::vector<ComparedMetric>& metrics);

}  // namespace cvo::reports
