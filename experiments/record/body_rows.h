// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/object_scores.h"
#include "reports/results/body_row.h"

namespace cvo {

// The rows of a result's bodies.
std::vector<reports::BodyRow> BodyRows(const std::vector<BodyScore>& bodies);

}  // namespace cvo
