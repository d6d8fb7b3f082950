// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "reports/results/metric_catalogue.h"
#include "reports/results/metric_value.h"

namespace cvo {

using Metric = reports::MetricValue;

// Makes a metric with the name and unit of the catalogue, and the part of the contract that the
// catalogue determines.
inline Metric MakeMetric(const reports::MetricForm& form, double value, std::int64_t n) {
  return {reports::MetricName(form), value, reports::EntryOf(form.id).unit, n,
          reports::RelationOf(form), ""};
}

// Enters into the contracts which poses were evaluated (causal, refined or from a file), and by how
// much the published calibration was changed for them.
inline void StatePoses(reports::PoseTime poses, double right_shift_px,
                       std::vector<Metric>& metrics) {
  for (Metric& metric : metrics) {
    metric.contract.poses = poses;
    metric.contract.right_shift_px = right_shift_px;
  }
}

}  // namespace cvo
