// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "reports/statistics/strata.h"

namespace cvo::reports {

inline constexpr int kResamples = 5000;
inline constexpr double kConfidence = 0.95;

struct Range {
  double low = 0.0;
  double high = 0.0;

  bool Contains(double value) const { return low <= value && value <= high; }
};

// Bootstrap: value and reference of resampled strata. For the same numbers of units, the same units
// are drawn. Of n units, n - 1 are drawn with replacement (McCarthy and Snowden 1985), since
// drawing n makes the interval of a mean too narrow by sqrt((n - 1) / n). A stratum of one unit
// stays as it is. Empty if no stratum has two units.
std::vector<std::array<double, 2>> Bootstrap(const std::vector<std::vector<Unit>>& strata,
                                             Within within);

// The interval that holds the middle kConfidence of the values. Empty if there are no values.
std::optional<Range> MiddleRange(std::vector<double> values);

// The minimum number of pairs of a significant difference. With fewer, not even differences of one
// sign would be unlikely enough by chance (two-sided sign test: 2 * 0.5^5 > 0.05), whatever the
// interval says.
inline constexpr std::size_t kMinPairs = 6;

// The difference, as a fraction of the reference, for which a table states how many scenes are
// needed to detect it.
inline constexpr double kPowerDifference = 0.1;

struct Estimate {
  double value = 0.0;
  std::optional<Range> interval;  // empty if nothing can be resampled
  std::size_t scenes = 0;
  std::size_t bodies = 0;
};

// The mean over scenes with its bootstrap interval. Empty if there are no samples.
std::optional<Estimate> EstimateMean(const std::vector<Sample>& samples, Within within);

// A value compared with its reference on the same scenes, bodies and repetitions.
struct PairedEstimate {
  double value = 0.0;
  double reference = 0.0;
  double difference = 0.0;  // value - reference
  std::optional<Range> interval;
  // The difference in percent of the reference, and in percent of the value, which is by how much
  // the reference is lower. Each is empty if the number it is a percentage of is not positive.
  std::optional<double> percent;
  std::optional<Range> percent_interval;
  std::optional<double> reference_lower;
  std::optional<Range> reference_lower_interval;
  std::optional<double> effect;   // difference / standard deviation of the pairs' differences
  std::optional<double> p_value;  // of no difference, uncorrected (PairedPValue)
  std::optional<std::size_t> scenes_for_10_percent;  // to detect kPowerDifference (PairsNeeded)
  std::size_t scenes = 0;
  std::size_t bodies = 0;
  std::size_t pairs = 0;  // units resampled: scenes, or bodies of the only scene
};

std::optional<PairedEstimate> EstimateDifference(const std::vector<Sample>& pairs, Within within);

}  // namespace cvo::reports
