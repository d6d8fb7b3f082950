// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// One line per cell whose paired difference is not 0: by how much, in which interval, and whether
// that can be told from noise; these first. "nothing moved" where there is none.
std::string MovedText(const Table& table);

}  // namespace cvo::reports
