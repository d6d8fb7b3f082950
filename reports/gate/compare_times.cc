// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/mean.h"
#include "reports/gate/compare.h"

namespace cvo::reports {
namespace {

constexpr double kMinFactor = 1.25;

struct Logarithms {
  double baseline = 0.0;  // sum over runs
  std::vector<double> differences;
};

TimeComparison Compare(const std::string& variant, const Logarithms& logarithms) {
  const double count = static_cast<double>(logarithms.differences.size());
  const double mean = MeanOf(logarithms.differences);
  const double squares = SquaresAroundMean(logarithms.differences);
  const double error = count > 1.0 ? std::sqrt(squares / (count - 1.0) / count) : 0.0;
  TimeComparison time;
  time.variant = variant;
  time.baseline = std::exp(logarithms.baseline / count);
  time.now = time.baseline * std::exp(mean);
  time.limit = std::max(kMinFactor, std::exp(kStandardErrors * error));
  time.pairs = logarithms.differences.size();
  time.verdict = std::exp(mean) > time.limit         ? Verdict::kWorse
                 : std::exp(mean) < 1.0 / time.limit ? Verdict::kBetter
                                                     : Verdict::kWithin;
  return time;
}

}  // namespace

std::vector<TimeComparison> CompareTimes(const std::vector<RunPair>& pairs) {
  std::map<std::string, Logarithms> by_variant;
  for (const RunPair& pair : pairs) {
    const std::optional<double>& then = pair.baseline->time_ratio;
    if (!then || !pair.time_ratio || *then <= 0.0 || *pair.time_ratio <= 0.0) continue;
    Logarithms& logarithms = by_variant[pair.baseline->keys.at("variant")];
    logarithms.baseline += std::log(*then);
    logarithms.differences.push_back(std::log(*pair.time_ratio / *then));
  }
  std::vector<TimeComparison> times;
  for (const auto& [variant, logarithms] : by_variant) {
    times.push_back(Compare(variant, logarithms));
  }
  return times;
}

}  // namespace cvo::reports
