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

// Rows of a table that differ in one option alone, by its value.
struct SweptLine {
  std::string label;                                   // of the other keys
  std::string variant;                                 // for its colour
  std::vector<std::pair<double, std::size_t>> points;  // value, index into Table::rows
};

// What a suite varies of an option.
struct SweptOption {
  std::string path;
  std::vector<double> values;           // ascending
  std::optional<double> default_value;  // where it is known
  bool log_spaced = false;
  std::vector<SweptLine> lines;
};

bool IsOption(const std::string& key);  // otherwise it identifies inputs and estimators

// The options that tell rows of the table apart by number. Why others are not drawn goes to
// `not_drawn`.
std::vector<SweptOption> FindSweptOptions(const SuitePlan& plan, const Table& table,
                                          std::vector<std::string>& not_drawn);

// Values that lie more evenly by their logarithm, over nearly a decade at least.
bool AreLogSpaced(const std::vector<double>& ascending);

// The variant of all runs; "all variants" where there are several.
std::string OneVariant(const SuitePlan& plan);

// The variant of a row; that of all runs where rows do not tell.
std::string VariantOf(const SuitePlan& plan, const Table& table, const Row& row);

}  // namespace cvo::reports
