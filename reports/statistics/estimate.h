// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "reports/statistics/bootstrap.h"
#include "reports/statistics/strata.h"

namespace cvo::reports {

// With fewer pairs not even all of one sign would be unlikely enough by chance (two-sided sign
// test: 2 * 0.5^5 > 0.05), whatever the interval says.
inline constexpr std::size_t kMinPairs = 6;

struct Estimate {
  double value = 0.0;
  std::optional<Range> interval;  // empty where nothing can be resampled
  std::size_t strata = 0;
  std::size_t units = 0;
};

// Mean over strata with its bootstrap interval. Empty without samples.
std::optional<Estimate> EstimateMean(const std::vector<Sample>& samples, Within within);

// A value against its reference on the same units and repetitions.
struct PairedEstimate {
  double value = 0.0;
  double reference = 0.0;
  double difference = 0.0;  // value - reference
  std::optional<Range> interval;
  // The difference in percent of the reference and of the value, which is by how much the reference
  // is lower; each empty where what it is a part of is not above 0.
  std::optional<double> percent;
  std::optional<Range> percent_interval;
  std::optional<double> reference_lower;
  std::optional<Range> reference_lower_interval;
  std::optional<double> effect;  // difference over the standard deviation of the units' own ones
  std::size_t strata = 0;
  std::size_t units = 0;
  bool distinguishable = false;  // interval excludes 0, with at least kMinPairs units
};

std::optional<PairedEstimate> EstimateDifference(const std::vector<Sample>& pairs, Within within);

}  // namespace cvo::reports
