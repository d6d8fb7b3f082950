// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/strata.h"

#include <map>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

void Add(const Part& part, Part& sum) {
  sum.sum += part.sum;
  sum.weight += part.weight;
}

}  // namespace

std::vector<std::vector<Unit>> AverageRepetitions(const std::vector<Sample>& samples) {
  // Ordered by repetition too: a sum depends on the order of its terms.
  std::map<std::string, std::map<std::string, std::map<std::string, const Sample*>>> ordered;
  for (const Sample& sample : samples) {
    const Sample*& slot = ordered[sample.stratum][sample.unit][sample.repetition];
    if (slot != nullptr) {
      ThrowError("statistics",
                 StrCat(sample.stratum, ", ", sample.unit, ", ", sample.repetition, " twice"),
                 "each sample once");
    }
    slot = &sample;
  }
  std::vector<std::vector<Unit>> strata;
  for (const auto& [stratum, units] : ordered) {
    strata.emplace_back();
    for (const auto& [unit, repetitions] : units) {
      Unit mean = {{Part{0.0, 0.0}, Part{0.0, 0.0}}};
      for (const auto& [repetition, sample] : repetitions) {
        Add(sample->value, mean.parts[0]);
        Add(sample->reference, mean.parts[1]);
      }
      for (Part& part : mean.parts) {
        part.sum /= static_cast<double>(repetitions.size());
        part.weight /= static_cast<double>(repetitions.size());
      }
      strata.back().push_back(mean);
    }
  }
  return strata;
}

std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within) {
  if (strata.empty()) return std::nullopt;
  std::array<double, 2> means = {0.0, 0.0};
  for (const std::vector<Unit>& units : strata) {
    for (std::size_t which = 0; which < means.size(); ++which) {
      Part total = {0.0, 0.0};
      for (const Unit& unit : units) Add(unit.parts[which], total);
      if (total.weight <= 0.0) return std::nullopt;
      means[which] += within == Within::kSum ? total.sum : total.sum / total.weight;
    }
  }
  for (double& mean : means) mean /= static_cast<double>(strata.size());
  return means;
}

}  // namespace cvo::reports
