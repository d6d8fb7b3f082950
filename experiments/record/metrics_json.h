// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json.h"
#include "experiments/metrics/metric.h"

namespace cvo {

// {name, value, unit, n, contract} per metric. Poses of one run can be scored as they were when
// their frame came (causal) or as last estimated (refined): `poses` says which, in the contract.
Json MetricsToJson(const std::vector<Metric>& metrics, const std::string& poses);

}  // namespace cvo
