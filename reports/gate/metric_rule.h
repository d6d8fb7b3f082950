// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace cvo::reports {

// How the gate reads a metric.
struct MetricRule {
  enum class Kind { kError, kFraction, kCount };

  Kind kind = Kind::kError;
  bool higher_is_better = false;

  // The least step worth telling, of a figure that is `value`: a hundredth of an error, 0.01 of a
  // fraction, one event.
  double Resolution(double value) const;
};

// Of metrics of the camera, of objects and of clustering; empty for others, which are not gated.
std::optional<MetricRule> FindRule(const std::string& metric);

}  // namespace cvo::reports
