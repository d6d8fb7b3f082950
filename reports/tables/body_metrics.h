// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "reports/results/metric_catalogue.h"
#include "reports/results/run_summary.h"
#include "reports/statistics/strata.h"

namespace cvo::reports {

// How a metric of a run follows from its bodies.
struct BodyMetric {
  MetricForm form;

  const MetricEntry& entry() const { return EntryOf(form.id); }
  bool predicted() const { return form.bodies == BodyGroup::kPredicted; }
  bool movers() const { return form.bodies != BodyGroup::kStanding; }
  // Its errors are listed frame by frame.
  bool by_frames() const { return form.id == MetricId::kObjectAte; }
  Within within() const {
    return entry().kind == MetricKind::kCount ? Within::kSum : Within::kMean;
  }
};

// Empty for a metric that is not about bodies.
std::optional<BodyMetric> FindBodyMetric(const std::string& metric);

// The bodies that it is about.
const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run);

// What a body adds; empty where the run does not tell.
std::optional<Part> PartOf(const BodyMetric& metric, const BodyRow& body);

// The same of one body in two runs: errors that are listed by frames over the frames of both.
std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyRow& body,
                                            const BodyRow& reference);

// In words what PairOf compares.
const char* PairingText(const BodyMetric& metric);

}  // namespace cvo::reports
