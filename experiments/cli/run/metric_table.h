// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <vector>

#include "experiments/metrics/metric.h"

namespace cvo {

// Name, value, unit and number of errors, one metric per line.
void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out);

}  // namespace cvo
