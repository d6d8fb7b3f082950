// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/json_fields.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Parts of a table.json; each throws Error naming the field.

// The cell of a column, in a row of that many runs.
Cell ReadCell(const Fields& fields, const Column& column, std::size_t runs);

ReferenceRow ReadReferenceRow(const Fields& fields, const std::vector<Column>& columns,
                              const std::vector<ReferenceSource>& sources);

}  // namespace cvo::reports
