// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/rng.h"

namespace cvo::reports {
namespace {

constexpr std::uint64_t kSeed = 1;

// Sums keep their scale: the drawn units represent all.
void Resample(const std::vector<Unit>& units, Within within, Rng& rng, std::vector<Unit>& drawn) {
  const std::size_t draws = units.size() - 1;
  const double scale =
      within == Within::kSum ? static_cast<double>(units.size()) / static_cast<double>(draws) : 1.0;
  drawn.resize(draws);
  for (Unit& unit : drawn) {
    unit = units[rng.UniformInt(units.size())];
    for (Part& part : unit.parts) part.sum *= scale;
  }
}

double Quantile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(at));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

}  // namespace

std::vector<std::array<double, 2>> Bootstrap(const std::vector<std::vector<Unit>>& strata,
                                             Within within) {
  const bool can_vary =
      std::any_of(strata.begin(), strata.end(), [](const auto& units) { return units.size() > 1; });
  if (!can_vary) return {};
  Rng rng(kSeed, "bootstrap");
  std::vector<std::vector<Unit>> drawn = strata;
  std::vector<std::array<double, 2>> means;
  means.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t s = 0; s < strata.size(); ++s) {
      if (strata[s].size() > 1) Resample(strata[s], within, rng, drawn[s]);
    }
    if (const auto mean = MeanOverStrata(drawn, within)) means.push_back(*mean);
  }
  return means;
}

std::optional<Range> MiddleRange(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double tail = 0.5 * (1.0 - kConfidence);
  return Range{Quantile(values, tail), Quantile(values, 1.0 - tail)};
}

}  // namespace cvo::reports
