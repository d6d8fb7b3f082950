// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/gate/gate_report.h"
#include "reports/gate/tolerance.h"

namespace cvo::reports {

// A run of now, and the baseline's of the same keys and seed.
struct RunPair {
  const BaselineJob* baseline = nullptr;
  std::map<std::string, double> values;  // by metric; only those that compare
  std::optional<double> time_ratio;
};

// How far seeds are apart, of one variant on one scene. From its own runs; or, because few seeds
// tell little, from those of all variants of the scene (errors relative to the variant's own) where
// its own are no further apart and this bounds the noise closer. Never less than one step of
// MetricEntry::Resolution in one of its runs. Empty where no variant has two seeds.
struct SeedSpread {
  double variance = 0.0;
  std::size_t degrees = 0;
};
std::optional<SeedSpread> SpreadOfSeeds(const Baseline& baseline, const BaselineMetric& metric,
                                        const std::map<std::string, std::string>& keys);

// Per variant and metric over all scenes, then, where there are several, scene by scene.
std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs);

// Per variant, from the ratios that both have. Slower or faster: by more than a quarter and by more
// than kStandardErrors standard errors of the paired differences of their logarithms.
std::vector<TimeComparison> CompareTimes(const std::vector<RunPair>& pairs);

}  // namespace cvo::reports
