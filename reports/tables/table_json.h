// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

inline constexpr int kTableSchemaVersion = 3;

// table.json: the same bytes for the same results.
std::string TableJson(const Table& table);

}  // namespace cvo::reports
