// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "reports/tables/table.h"
namespace cvo::reports {
std::string TableHtml(const Table& table);
}
