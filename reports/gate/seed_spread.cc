// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "reports/gate/compare.h"
#include "reports/gate/metric_rule.h"

namespace cvo::reports {
namespace {

using Keys = std::map<std::string, std::string>;

// Values of one metric on one scene, by variant.
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

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double SquaresAroundMean(const std::vector<double>& values) {
  const double mean = Mean(values);
  return std::accumulate(values.begin(), values.end(), 0.0, [mean](double sum, double value) {
    return sum + (value - mean) * (value - mean);
  });
}

}  // namespace

std::optional<SeedSpread> SpreadOfSeeds(const Baseline& baseline, const BaselineMetric& metric,
                                        const Keys& keys) {
  const auto values = ValuesByVariant(baseline, metric.name, keys);
  const auto own = values.find(keys.at("variant"));
  if (own == values.end()) return std::nullopt;
  const std::optional<MetricRule> rule = FindRule(metric.name);
  if (!rule) return std::nullopt;
  const double own_mean = Mean(own->second);
  const double count = static_cast<double>(own->second.size());
  SeedSpread spread;
  double squares = 0.0;
  for (const auto& [variant, of_variant] : values) {
    const double mean = Mean(of_variant);
    const bool relative = rule->kind == MetricRule::Kind::kError && mean > 0.0;
    const double scale = relative ? own_mean / mean : 1.0;
    squares += scale * scale * SquaresAroundMean(of_variant);
    spread.degrees += of_variant.size() - 1;
  }
  if (spread.degrees == 0) return std::nullopt;
  const double resolution = rule->Resolution(own_mean);
  spread.variance =
      std::max(squares / static_cast<double>(spread.degrees), resolution * resolution / count);
  if (count > 1.0) {
    spread.variance = std::max(spread.variance, SquaresAroundMean(own->second) / (count - 1.0));
  }
  return spread;
}

}  // namespace cvo::reports
