// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/estimate.h"

#include <algorithm>
#include <cmath>

namespace cvo::reports {
namespace {

std::size_t CountUnits(const std::vector<std::vector<Unit>>& strata) {
  std::size_t units = 0;
  for (const auto& stratum : strata) units += stratum.size();
  return units;
}

double Figure(const Part& part, Within within) {
  return within == Within::kSum ? part.sum : part.sum / part.weight;
}

std::optional<double> EffectSize(const std::vector<std::vector<Unit>>& strata, Within within,
                                 double difference) {
  std::vector<double> differences;
  for (const auto& units : strata) {
    for (const Unit& unit : units) {
      if (unit.parts[0].weight <= 0.0 || unit.parts[1].weight <= 0.0) continue;
      differences.push_back(Figure(unit.parts[0], within) - Figure(unit.parts[1], within));
    }
  }
  if (differences.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(differences.size());
  double mean = 0.0;
  for (const double d : differences) mean += d / n;
  double variance = 0.0;
  for (const double d : differences) variance += (d - mean) * (d - mean) / (n - 1.0);
  // All alike up to rounding: their spread says nothing.
  if (std::sqrt(variance) <= 1e-12 * std::abs(mean) || variance == 0.0) return std::nullopt;
  return difference / std::sqrt(variance);
}

// In percent of `whole` of each pair (0: the value, 1: the reference); empty where one is not
// above 0.
std::optional<Range> PercentRange(const std::vector<std::array<double, 2>>& pairs,
                                  std::size_t whole) {
  std::vector<double> percents;
  for (const std::array<double, 2>& pair : pairs) {
    if (!(pair[whole] > 0.0)) return std::nullopt;
    percents.push_back(100.0 * (pair[0] - pair[1]) / pair[whole]);
  }
  return MiddleRange(std::move(percents));
}

}  // namespace

std::optional<Estimate> EstimateMean(const std::vector<Sample>& samples, Within within) {
  const std::vector<std::vector<Unit>> strata = AverageRepetitions(samples);
  const auto mean = MeanOverStrata(strata, within);
  if (!mean) return std::nullopt;
  Estimate estimate;
  estimate.value = (*mean)[0];
  estimate.strata = strata.size();
  estimate.units = CountUnits(strata);
  std::vector<double> values;
  for (const auto& resampled : Bootstrap(strata, within)) values.push_back(resampled[0]);
  estimate.interval = MiddleRange(std::move(values));
  return estimate;
}

std::optional<PairedEstimate> EstimateDifference(const std::vector<Sample>& pairs, Within within) {
  const std::vector<std::vector<Unit>> strata = AverageRepetitions(pairs);
  const auto mean = MeanOverStrata(strata, within);
  if (!mean) return std::nullopt;
  PairedEstimate estimate;
  estimate.value = (*mean)[0];
  estimate.reference = (*mean)[1];
  estimate.difference = estimate.value - estimate.reference;
  estimate.strata = strata.size();
  estimate.units = CountUnits(strata);
  estimate.effect = EffectSize(strata, within, estimate.difference);
  const std::vector<std::array<double, 2>> resampled = Bootstrap(strata, within);
  std::vector<double> differences;
  for (const auto& [value, reference] : resampled) differences.push_back(value - reference);
  estimate.interval = MiddleRange(std::move(differences));
  if (estimate.reference > 0.0) {
    estimate.percent = 100.0 * estimate.difference / estimate.reference;
    estimate.percent_interval = PercentRange(resampled, 1);
  }
  if (estimate.value > 0.0) {
    estimate.reference_lower = 100.0 * estimate.difference / estimate.value;
    estimate.reference_lower_interval = PercentRange(resampled, 0);
  }
  estimate.distinguishable =
      estimate.interval && !estimate.interval->Contains(0.0) && estimate.units >= kMinPairs;
  return estimate;
}

}  // namespace cvo::reports
