// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// Corrects the p-values of differences that are read together for their number (Holm), and says
// which of them can be told from noise.
void CorrectForMany(const std::vector<Difference*>& differences);

// All differences of a table.
void CorrectForMany(Table& table);

}  // namespace cvo::reports
