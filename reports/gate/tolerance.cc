// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/tolerance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/median.h"
#include "reports/statistics/student.h"

namespace cvo::reports {
namespace {

// Returns the standard error of the mean difference, from the median absolute deviation.
double RobustStandardError(std::vector<double> differences) {
  constexpr double kSigmaOfDeviation = 1.4826;  // for a normal distribution
  const double median = Median(differences);
  for (double& difference : differences) difference = std::abs(difference - median);
  const double count = static_cast<double>(differences.size());
  return kSigmaOfDeviation * Median(std::move(differences)) / std::sqrt(count);
}

// The standard error of a mean over scenes, with its effective degrees of freedom (Welch and
// Satterthwaite).
struct SeedError {
  double standard_error = 0.0;
  int degrees = 1;
};

SeedError ErrorOfSeeds(const std::vector<const SceneDifferences*>& scenes) {
  const double count = static_cast<double>(scenes.size());
  double sum = 0.0;
  double spread = 0.0;
  for (const SceneDifferences* scene : scenes) {
    Require(scene->seed_degrees >= 1, "Tolerance: a scene without a spread over seeds");
    // Twice, because both the baseline and the checked runs are random draws.
    const double variance =
        2.0 * scene->seed_variance / static_cast<double>(scene->worse_by.size()) / (count * count);
    sum += variance;
    spread += variance * variance / static_cast<double>(scene->seed_degrees);
  }
  if (sum <= 0.0) return {};
  const double degrees = std::clamp(std::floor(sum * sum / spread), 1.0, 1000.0);
  return {std::sqrt(sum), static_cast<int>(degrees)};
}

}  // namespace

double Tolerance(const std::vector<SceneDifferences>& scenes, std::size_t comparisons) {
  std::vector<const SceneDifferences*> measured;
  std::vector<double> differences;
  for (const SceneDifferences& scene : scenes) {
    if (scene.worse_by.empty()) continue;
    measured.push_back(&scene);
    differences.insert(differences.end(), scene.worse_by.begin(), scene.worse_by.end());
  }
  if (measured.empty()) return 0.0;
  const SeedError seeds = ErrorOfSeeds(measured);
  const double tail = kFalseAlarms / static_cast<double>(std::max<std::size_t>(comparisons, 1));
  return std::max(kStandardErrors * RobustStandardError(std::move(differences)),
                  StudentQuantile(std::max(tail, 1e-9), seeds.degrees) * seeds.standard_error);
}

double MeanDifference(const std::vector<SceneDifferences>& scenes) {
  double sum = 0.0;
  double count = 0.0;
  for (const SceneDifferences& scene : scenes) {
    if (scene.worse_by.empty()) continue;
    sum += std::accumulate(scene.worse_by.begin(), scene.worse_by.end(), 0.0) /
           static_cast<double>(scene.worse_by.size());
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace cvo::reports
