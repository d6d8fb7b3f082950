// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/tables/reference.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// One line to be: a result file or, where there is none, why.
struct TableEntry {
  std::string name;                   // of the sequence, where the file cannot say it
  std::filesystem::path result_file;  // empty: the run gave none
  std::string message;                // then: why
};

struct TableRequest {
  std::string title;
  std::vector<std::string> metrics;  // columns; those that no result has are left out
  std::filesystem::path folder;      // that links are relative to; empty: as the files are given
  std::vector<TableEntry> entries;   // rows keep their order
};

// The columns for the trajectory of the camera.
std::vector<std::string> CameraMetrics();
// Those for moving bodies: the paper's ablation (its table 4), what was covered, and who is who.
std::vector<std::string> ObjectMetrics();

// Results that differ in their seed only share a row. What cannot be read or is missing becomes a
// row or cell that says so. Throws Error for no entries, for two results of the same run, and,
// naming both files, where two results mean different things by the same metric: anywhere in its
// definition, or in the truth within one type of dataset.
Table MakeTable(const TableRequest& request, const Reference& reference);

// Every entry was read and ended well.
bool IsComplete(const Table& table);

}  // namespace cvo::reports
