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

// How a metric of a run is computed from its bodies.
struct BodyMetric {
  MetricForm form;

  const MetricEntry& entry() const { return EntryOf(form.id); }
  bool predicted() const { return form.bodies == BodyGroup::kPredicted; }
  bool movers() const { return form.bodies != BodyGroup::kStanding; }
  // Whether the errors of the metric are listed frame by frame.
  bool by_frames() const { return form.id == MetricId::kObjectAte; }
  Within within() const {
    return entry().kind == MetricKind::kCount ? Within::kSum : Within::kMean;
  }
};

// Empty if the metric is not about bodies.
std::optional<BodyMetric> FindBodyMetric(const std::string& metric);

// The bodies of a run from which the metric is computed.
const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run);

// The contribution of a body to the metric. Empty if the metric does not apply to the body or the
// run has no value for it.
std::optional<Part> PartOf(const BodyMetric& metric, const BodyRow& body);

// The contributions of the same body in two runs. Errors that are listed by frame are taken over
// the frames that both runs have.
std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyRow& body,
                                            const BodyRow& reference);

// Describes in words what PairOf compares.
const char* PairingText(const BodyMetric& metric);

}  // namespace cvo::reports
