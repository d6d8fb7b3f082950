// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/tables/reference.h"
#include "reports/tables/run_summary.h"

namespace cvo::reports {

struct Column {
  std::string metric;
  std::string label;
  std::string unit;
  Contract contract;  // what all its cells share
};

// Of the runs of one cell that differ in their seeds only.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  std::string meaning;
};

struct Cell {
  bool present = false;
  double value = 0.0;  // of one run, or the mean over seeds
  std::int64_t n = 0;  // errors behind the value, over all runs
  std::optional<Interval> interval;
  std::string left_out;
  std::string message;  // why there is no value
};

// How a figure of others relates to ours in the same row and column.
enum class Match { kMatches, kOtherFrames, kOtherImages, kContractUnknown, kContractDiffers };
const char* ToString(Match match);

struct ReferenceCell {
  double value = 0.0;
  Match match = Match::kMatches;
  std::string reason;  // what differs or is not stated
};

struct ReferenceRow {
  std::size_t source = 0;  // index in Table::sources
  std::string system;
  int first_frame = 0;
  int frames = 0;
  std::vector<std::optional<ReferenceCell>> cells;  // one per column
};

// One variant on one sequence.
struct Row {
  SequenceInfo sequence;
  std::string variant;
  std::vector<std::uint64_t> seeds;
  std::string truth;
  std::string status;              // "ok", "lost", "failed", "unreadable"
  std::string message;             // empty where ok
  std::vector<std::string> links;  // result.json of each run, relative to the table
  std::vector<Cell> cells;         // one per column
  std::vector<ReferenceRow> reference;
};

struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::vector<ReferenceSource> sources;  // that the rows refer to
  std::vector<std::string> notes;        // what a reader must know to compare rows
};

}  // namespace cvo::reports
