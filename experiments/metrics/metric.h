// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "reports/results/metric_catalogue.h"
#include "reports/results/metric_value.h"

namespace cvo {

using Metric = reports::MetricValue;

// With the name and unit of the catalogue, and the part of the contract that it knows.
inline Metric MakeMetric(const reports::MetricForm& form, double value, std::int64_t n) {
  return {reports::MetricName(form), value, reports::EntryOf(form.id).unit, n,
          reports::RelationOf(form), ""};
}

// Says of poses whose they are, and what of the published calibration was changed for them.
inline void StatePoses(reports::PoseTime poses, double right_shift_px,
                       std::vector<Metric>& metrics) {
  for (Metric& metric : metrics) {
    metric.contract.poses = poses;
    metric.contract.right_shift_px = right_shift_px;
  }
}

}  // namespace cvo
