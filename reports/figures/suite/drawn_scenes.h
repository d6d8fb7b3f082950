// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// The runs of one sequence, one per variant.
struct DrawnScene {
  std::string sequence;
  std::vector<const DrawnRun*> runs;
};

// Groups the runs by sequence, in the order of the data. `runs` must outlive the result.
std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs);

std::vector<std::string> VariantsOf(const std::vector<DrawnRun>& runs);

// The seeds of the runs: "seed 1" if they are the same, or "seeds: full 1, 2d 2".
std::string SeedText(const DrawnScene& scene);

// How the truth is aligned to the world frame of a run, for titles and captions.
inline constexpr const char* kTruthAlignment =
    "truth aligned by the camera (rotation: mean over its orientations, translation: over its "
    "positions), one rigid offset per body";

}  // namespace cvo::reports
