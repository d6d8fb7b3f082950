// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/lists.h"
#include "core/record/run_summary.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {

struct ReferenceSource {
  std::string id;
  std::string source;  // citation for readers
  std::string kind;    // "published" or "measured"
  std::string caveat;
  std::string pair;  // images that were used; empty: unknown

  CVO_FIELDS(id, source, kind, caveat);
};

struct Column {
  std::string metric;
  std::string label;
  std::string unit;
  Contract contract;  // the fields that all its cells share

  CVO_FIELDS(metric, label, unit, contract);
};

// What the intervals of values and differences are, for notes and captions.
inline constexpr char kIntervalMeaning[] =
    "95 %, bootstrap over scenes within their families, with seeds averaged; of a single scene "
    "over its bodies, which says nothing about other scenes, or from its least run to its largest";

// What a value is a mean over.
struct Counts {
  std::size_t runs = 0;
  std::size_t scenes = 0;
  std::size_t bodies = 0;  // 0: a metric of whole runs
  std::size_t seeds = 0;

  CVO_FIELDS(runs, scenes, bodies, seeds);
};

// A cell compared with the same cell of the reference row, both over what the two have in common.
struct Difference : PairedEstimate {
  // The interval excludes 0, adjusted_p_value is below 5 %, and there are enough pairs.
  bool distinguishable = false;
  std::optional<double> adjusted_p_value = {};  // corrected for all comparisons of the table (Holm)
  // camera_truth_gap of the runs, where the difference is smaller: the truth does not decide it, so
  // it has no percentage and no p-value.
  std::optional<double> truth_gap = {};

  CVO_RECORD(CVO_FIELD(value, reference_value, difference) CVO_OPTIONAL(interval, percent)
                 CVO_FIELD(distinguishable, pairs)
                     CVO_OPTIONAL(p_value, adjusted_p_value, truth_gap));
};

struct Cell {
  std::optional<double> value;
  Counts n;
  std::optional<Interval> interval;
  std::optional<Difference> difference;
  std::string left_out;
  std::string message;         // why there is no value
  std::string not_comparable;  // why the value is not comparable with the others of its column

  CVO_RECORD(CVO_OPTIONAL(value) CVO_FIELD(n)
                 CVO_OPTIONAL(interval, difference, left_out, message, not_comparable));
};

// Whether a reference figure is comparable with ours in the same row and column, and if not, why.
enum class Match {
  kMatches,
  kOtherScenes,
  kOtherFrames,
  kOtherImages,
  kContractUnknown,
  kContractDiffers
};
constexpr std::array<const char*, 6> EnumNames(Match) {
  return {"matches",      "other scenes",        "other frames",
          "other images", "contract not stated", "contract differs"};
}

// A reference figure in the column of its metric.
struct ReferenceCell {
  std::string metric;
  std::string unit;
  double value = 0.0;
  Match match = Match::kMatches;
  std::string reason = {};  // what differs, is not stated or was inferred

  CVO_RECORD(CVO_FIELD(metric, unit, value, match) CVO_OPTIONAL(reason));
};

struct ReferenceRow {
  std::string source;  // ReferenceSource::id
  std::string system;
  int first_frame = 0;
  int frames = 0;  // 0: unknown
  std::vector<ReferenceCell> cells = {};

  // nullptr if it has no figure in this column.
  const ReferenceCell* Find(const Column& column) const {
    return FindBy(cells, &ReferenceCell::metric, column.metric);
  }

  CVO_FIELDS(source, system, first_frame, frames, cells);
};

// The number of jobs of a row or table by outcome.
struct JobCounts {
  std::size_t planned = 0;
  std::size_t done = 0;
  std::size_t lost = 0;  // of those done: the estimator lost the camera
  std::size_t failed = 0;
  std::size_t not_run = 0;
  std::size_t no_data = 0;  // the sequence is not on this machine

  CVO_FIELDS(planned, done, lost, failed, not_run, no_data);
};

struct RunLink {
  std::string sequence;
  std::uint64_t seed = 0;
  std::string result;  // relative to the table

  CVO_FIELDS(sequence, seed, result);
};

struct Row {
  std::vector<std::string> keys;         // values of Table::keys
  std::optional<SequenceInfo> sequence;  // if all its runs are of the same sequence and frames
  Contract truth;                        // in that case; only truth, visibility and correction
  std::string corrections;               // of the calibrations of its runs; empty: none
  std::string split;  // of its scenes: "development", "test"; "given" for recorded images
  JobCounts jobs;
  std::vector<RunLink> runs;
  std::vector<Cell> cells;  // one per column
  std::vector<ReferenceRow> reference;

  CVO_RECORD(CVO_FIELD(keys) CVO_OPTIONAL(sequence, truth, corrections, split)
                 CVO_FIELD(jobs, runs, cells, reference));
};

// A job without a result, or with one to be read with care.
struct Problem {
  std::string row;
  std::string sequence;
  std::uint64_t seed = 0;
  std::string state;  // "failed", "lost", "not run", "no data"
  std::string message;
  std::string log;  // of a failed job

  CVO_RECORD(CVO_FIELD(row, sequence, seed, state, message) CVO_OPTIONAL(log));
};

// An option that at least one run does not leave at its default. Values are JSON texts.
struct ChangedOption {
  std::string path;
  std::string default_value;
  std::vector<std::string> values;

  CVO_FIELDS(path, default_value, values);
};

struct Provenance {
  std::vector<std::string> builds;
  std::vector<std::uint64_t> seeds;
  std::vector<ChangedOption> options;

  CVO_FIELDS(builds, seeds, options);
};

// The contents of table.json.
struct Table {
  static constexpr int kSchemaVersion = 5;
  static constexpr const char* kKind = "table";

  std::string title;
  std::string about;
  std::string reference;          // what differences are relative to; empty: no reference
  bool change = false;            // the reference is an earlier result, not a row of this table
  std::vector<std::string> keys;  // the keys that identify a row
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::vector<ReferenceRow> others;      // reference figures that belong to no row
  std::vector<ReferenceSource> sources;  // of all reference rows
  JobCounts jobs;
  std::vector<Problem> problems;
  std::vector<std::string> notes;  // what a reader must know to compare rows
  Provenance provenance;

  CVO_RECORD(CVO_FIELD(title, about, reference, keys, columns, rows, others, sources, jobs,
                       problems, notes, provenance) CVO_OPTIONAL(change));
};

// The values of the keys of a row, such as "indoor_1 full".
inline std::string RowLabel(const Row& row) { return Joined(row.keys, " "); }

// "0:72": the frames from the first one on.
inline std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

// The text of table.json. The same results give the same bytes. Throws Error naming the value if
// one is not finite.
inline std::string TableJson(const Table& table) { return FileText(table); }

}  // namespace cvo::reports
