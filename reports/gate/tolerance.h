// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace cvo::reports {

// Probability that a whole check raises a false alarm when nothing but the noise changed.
inline constexpr double kFalseAlarms = 0.01;
// Number of standard errors of the paired differences that a mean difference must exceed.
inline constexpr double kStandardErrors = 3.0;

// For one scene, by how much its runs are worse than the baseline's with the same seeds, and the
// spread due to seeds alone.
struct SceneDifferences {
  std::vector<double> worse_by;
  double seed_variance = 0.0;    // of a single run
  std::size_t seed_degrees = 0;  // degrees of freedom of that variance
};

// Returns by how much the mean over scenes may be worse: the larger of
//  - kStandardErrors standard errors of the differences, estimated from their median absolute
//    deviation, so that a single broken scene does not widen its own tolerance;
//  - the expected difference between two draws of seeds: StudentQuantile(kFalseAlarms /
//    comparisons) times the standard error that follows from the variances of the seeds.
// Scenes without differences do not count.
double Tolerance(const std::vector<SceneDifferences>& scenes, std::size_t comparisons);

// Returns the mean over scenes of the mean over their runs, or 0 if there are none.
double MeanDifference(const std::vector<SceneDifferences>& scenes);

}  // namespace cvo::reports
