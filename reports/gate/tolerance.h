// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace cvo::reports {

// False alarms that a whole check may raise when nothing but the noise changed, as a probability.
inline constexpr double kFalseAlarms = 0.01;
// Standard errors of the paired differences that a mean difference must exceed.
inline constexpr double kStandardErrors = 3.0;

// Of one scene: by how much its runs are worse than the baseline's of the same seeds, and how far
// seeds alone are apart there.
struct SceneDifferences {
  std::vector<double> worse_by;
  double seed_variance = 0.0;    // of a run
  std::size_t seed_degrees = 0;  // of freedom of that variance
};

// By how much the mean over scenes may be worse: the larger of
//  - kStandardErrors standard errors of the differences, by their median absolute deviation, so
//    that one scene that breaks does not widen what it is held against;
//  - what two draws of seeds differ by: StudentQuantile(kFalseAlarms / comparisons) times the
//    standard error that the variances of the seeds give.
// Scenes without differences do not count.
double Tolerance(const std::vector<SceneDifferences>& scenes, std::size_t comparisons);

// Mean over scenes of the mean over their runs; 0 where there are none.
double MeanDifference(const std::vector<SceneDifferences>& scenes);

}  // namespace cvo::reports
