// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/results/suite_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Rows of a table that differ only in one option, by its value.
struct SweptLine {
  std::string label;                                   // made of the other keys
  std::string variant;                                 // sets the colour
  std::vector<std::pair<double, std::size_t>> points;  // value, index into Table::rows
};

// The values that a suite tries for one option.
struct SweptOption {
  std::string path;
  std::vector<double> values;           // ascending
  std::optional<double> default_value;  // empty: unknown
  bool log_spaced = false;
  std::vector<SweptLine> lines;
};

bool IsOption(const std::string& key);  // other keys identify inputs and estimators

// The options with several numeric values that distinguish rows of the table. Appends to
// `not_drawn` why the others are not drawn.
std::vector<SweptOption> FindSweptOptions(const SuitePlan& plan, const Table& table,
                                          std::vector<std::string>& not_drawn);

// Whether the values are spaced more evenly by their logarithm. They must span nearly a decade.
bool AreLogSpaced(const std::vector<double>& ascending);

// The variant of all runs, or "all variants" if there are several.
std::string OneVariant(const SuitePlan& plan);

// The variant of a row. If the variant is no key of the rows, the same as OneVariant.
std::string VariantOf(const SuitePlan& plan, const Table& table, const Row& row);

}  // namespace cvo::reports
