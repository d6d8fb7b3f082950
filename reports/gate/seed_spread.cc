// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/mean.h"
#include "reports/gate/compare.h"
#include "reports/results/metric_catalogue.h"
#include "reports/statistics/student.h"

namespace cvo::reports {
namespace {

using Keys = std::map<std::string, std::string>;

// Returns the values of one metric on one scene, by variant.
std::map<std::string, std::vector<double>> ValuesByVariant(const Baseline& baseline,
                                                           const std::string& metric, Keys keys) {
  std::map<std::string, std::vector<double>> values;
  for (const BaselineJob& job : baseline.jobs) {
    keys["variant"] = job.keys.at("variant");
    const auto value = job.values.find(metric);
    if (job.keys == keys && value != job.values.end()) {
      values[keys["variant"]].push_back(value->second);
    }
  }
  return values;
}

// Returns the spread pooled over all variants, with errors scaled to a mean of `own_mean`.
SeedSpread Pooled(const std::map<std::string, std::vector<double>>& values, const MetricEntry& rule,
                  double own_mean) {
  SeedSpread pooled;
  double squares = 0.0;
  for (const auto& [variant, of_variant] : values) {
    const double mean = MeanOf(of_variant);
    const bool relative = rule.kind == MetricKind::kError && mean > 0.0;
    const double scale = relative ? own_mean / mean : 1.0;
    squares += scale * scale * SquaresAroundMean(of_variant);
    pooled.degrees += of_variant.size() - 1;
  }
  if (pooled.degrees > 0) pooled.variance = squares / static_cast<double>(pooled.degrees);
  return pooled;
}

// Returns a bound that noise of this spread exceeds about as rarely as a check may fail because of
// it.
double Reach(const SeedSpread& spread) {
  return std::sqrt(spread.variance) * StudentQuantile(1e-4, static_cast<int>(spread.degrees));
}

}  // namespace

std::optional<SeedSpread> SpreadOfSeeds(const Baseline& baseline, const BaselineMetric& metric,
                                        const Keys& keys) {
  const auto values = ValuesByVariant(baseline, metric.name, keys);
  const auto found = values.find(keys.at("variant"));
  const MetricEntry* rule = FindEntry(metric.name);
  if (found == values.end() || !rule) return std::nullopt;
  const double mean = MeanOf(found->second);
  const double count = static_cast<double>(found->second.size());
  SeedSpread own;
  own.degrees = found->second.size() - 1;
  if (count > 1.0) own.variance = SquaresAroundMean(found->second) / (count - 1.0);
  const SeedSpread pooled = Pooled(values, *rule, mean);
  if (pooled.degrees == 0) return std::nullopt;
  const bool is_quiet = own.degrees == 0 || own.variance <= pooled.variance;
  SeedSpread spread = own;
  if (is_quiet && (own.degrees == 0 || Reach(pooled) < Reach(own))) spread = pooled;
  const double resolution = rule->Resolution(mean);
  spread.variance = std::max(spread.variance, resolution * resolution / count);
  return spread;
}

}  // namespace cvo::reports
