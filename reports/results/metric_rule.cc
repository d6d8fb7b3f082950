// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/metric_rule.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cvo::reports {
namespace {

template <std::size_t n>
bool Contains(const std::array<const char*, n>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// What is left of "object_causal_standing_ate" and the like: the quantity itself.
std::optional<std::string> Quantity(std::string metric) {
  bool known = false;
  for (const char* group : {"camera_", "object_", "causal_", "predicted_", "standing_"}) {
    const std::string prefix = group;
    if (!metric.starts_with(prefix)) continue;
    metric.erase(0, prefix.size());
    known = true;
  }
  if (!known && !metric.starts_with("moving_") && !metric.starts_with("clustering_")) {
    return std::nullopt;
  }
  return metric;
}

}  // namespace

double MetricRule::Resolution(double value) const {
  switch (kind) {
    case Kind::kError:
      return 0.01 * std::abs(value);
    case Kind::kFraction:
      return 0.01;
    case Kind::kCount:
      return 1.0;
  }
  return 0.0;
}

std::optional<MetricRule> FindRule(const std::string& metric) {
  constexpr std::array errors = {
      "ate",          "ate_mean",     "ate_median", "ate_max", "rrpe_all_pairs", "trpe_all_pairs",
      "rrpe_1_frame", "trpe_1_frame", "t_drift",    "r_drift", "motion_r",       "motion_t",
      "velocity"};
  constexpr std::array fractions = {"coverage",       "success_5cm",      "success_10cm",
                                    "success_20cm",   "moving_precision", "moving_recall",
                                    "clustering_iou", "clustering_ari"};
  constexpr std::array counts = {"id_switches", "fragments", "unmatched", "unmatched_clusters"};
  const std::optional<std::string> quantity = Quantity(metric);
  if (!quantity) return std::nullopt;
  if (Contains(errors, *quantity)) return MetricRule{MetricRule::Kind::kError, false};
  if (Contains(fractions, *quantity)) return MetricRule{MetricRule::Kind::kFraction, true};
  if (Contains(counts, *quantity)) return MetricRule{MetricRule::Kind::kCount, false};
  return std::nullopt;
}

// Metrics that share a coverage have its name in common up to "coverage".
std::string CoverageOf(const std::string& metric) {
  for (const char* group : {"object_causal_standing_", "object_standing_", "object_causal_",
                            "object_", "camera_causal_", "camera_"}) {
    if (metric.starts_with(group)) return std::string(group) + "coverage";
  }
  return "";
}

}  // namespace cvo::reports
