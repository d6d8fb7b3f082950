// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "reports/tables/table.h"

namespace cvo::reports {

// A table.json read back: TableJson gives the same bytes again. What only results know is left at
// its default: the pair of a source, hash and calibration of a sequence. Throws Error naming
// `where` and the field: half-written, of another schema version, no table.
Table ReadTable(std::string_view json, const std::string& where);
Table ReadTableFile(const std::filesystem::path& file);

}  // namespace cvo::reports
