// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// Describes for a title how metrics are measured. Metrics that are measured alike are listed
// together: "object ATE: aligned in the world frame by the camera; camera T.RPE: delta all, not
// aligned". Empty for shares and counts.
std::string RelationText(const std::vector<const Column*>& columns);

// Describes the intervals of these columns, each wording once.
std::string IntervalText(const Table& table, const std::vector<std::size_t>& columns);

}  // namespace cvo::reports
