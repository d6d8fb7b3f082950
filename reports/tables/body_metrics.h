// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "reports/results/run_summary.h"
#include "reports/statistics/strata.h"

namespace cvo::reports {

// How a metric of a run follows from its bodies.
struct BodyMetric {
  enum class Kind { kError, kCoverage, kSuccess, kCount, kUnmatched };

  Kind kind = Kind::kError;
  bool causal = false;
  bool predicted = false;
  bool movers = true;      // else: bodies that stay put
  std::string field;       // of BodyResult::values
  double scale = 1.0;      // from its unit to that of the metric
  double limit_m = 0.0;    // of a success
  bool by_frames = false;  // its errors are listed frame by frame

  Within within() const {
    return kind == Kind::kCount || kind == Kind::kUnmatched ? Within::kSum : Within::kMean;
  }
};

// Empty for a metric that is not about bodies, or not known here.
std::optional<BodyMetric> FindBodyMetric(const std::string& metric);

// The bodies that it is about.
const std::vector<BodyResult>& BodiesOf(const BodyMetric& metric, const RunSummary& run);

// What a body adds; empty where the run does not tell.
std::optional<Part> PartOf(const BodyMetric& metric, const BodyResult& body);

// The same of one body in two runs: errors that are listed by frames over the frames of both.
std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyResult& body,
                                            const BodyResult& reference);

// In words what PairOf compares.
const char* PairingText(const BodyMetric& metric);

}  // namespace cvo::reports
