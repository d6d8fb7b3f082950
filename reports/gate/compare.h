// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/gate/gate_report.h"
#include "reports/gate/tolerance.h"

namespace cvo::reports {

// A run to check and the baseline's run with the same keys and seed.
struct RunPair {
  const BaselineJob* baseline = nullptr;
  std::map<std::string, double> values;  // of the run to check, by metric; only comparable ones
  std::optional<double> time_ratio;
};

// The spread between seeds of one variant on one scene. It is estimated from the variant's own runs
// or, because few seeds tell little, from the runs of all variants on the scene (with errors scaled
// to the variant's own mean), if its own variance is no larger and pooling gives a tighter bound on
// the noise. It is never less than one step of MetricEntry::Resolution in one of its runs. Empty if
// no variant has two seeds.
struct SeedSpread {
  double variance = 0.0;
  std::size_t degrees = 0;
};
std::optional<SeedSpread> SpreadOfSeeds(const Baseline& baseline, const BaselineMetric& metric,
                                        const std::map<std::string, std::string>& keys);

// Returns one comparison per variant and metric over all scenes and, if there are several, one for
// each scene.
std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs);

// Returns one comparison per variant, from the runs for which both sides have a time ratio. Slower
// or faster means by more than a quarter and by more than kStandardErrors standard errors of the
// paired differences of the logarithms.
std::vector<TimeComparison> CompareTimes(const std::vector<RunPair>& pairs);

}  // namespace cvo::reports
