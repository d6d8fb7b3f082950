// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace cvo::reports {

// What kind of figure a metric is, and which way is better.
struct MetricRule {
  enum class Kind { kError, kFraction, kCount };

  Kind kind = Kind::kError;
  bool higher_is_better = false;

  // The least step worth telling, of a figure that is `value`: a hundredth of an error, 0.01 of a
  // fraction, one event.
  double Resolution(double value) const;
};

// Of metrics of the camera, of objects and of clustering; empty for others: these are neither gated
// nor is one of them called the best.
std::optional<MetricRule> FindRule(const std::string& metric);

// The coverage that a metric must be read with, such as "object_coverage" for "object_ate"; empty
// for those of clustering.
std::string CoverageOf(const std::string& metric);

}  // namespace cvo::reports
