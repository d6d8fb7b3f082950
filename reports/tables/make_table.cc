// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/make_table.h"

#include <algorithm>

#include "core/base/error.h"
#include "reports/tables/columns.h"
#include "reports/tables/reference_rows.h"

namespace cvo::reports {
namespace {

// The runs of one row, by seed; without runs, why there are none.
struct Group {
  std::vector<RunSummary> runs;
  std::string name;
  std::string status;
  std::string message;
};

bool SameRow(const RunSummary& a, const RunSummary& b) {
  return a.sequence.name == b.sequence.name && a.sequence.type == b.sequence.type &&
         a.sequence.pair == b.sequence.pair && a.sequence.first_frame == b.sequence.first_frame &&
         a.sequence.frames == b.sequence.frames && a.variant == b.variant;
}

void AddRun(RunSummary run, std::vector<Group>& groups) {
  const auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& candidate) {
    return !candidate.runs.empty() && SameRow(candidate.runs[0], run);
  });
  if (group == groups.end()) {
    groups.push_back({{std::move(run)}, "", "", ""});
    return;
  }
  const auto at = std::find_if(group->runs.begin(), group->runs.end(),
                               [&](const RunSummary& other) { return other.seed >= run.seed; });
  if (at != group->runs.end() && at->seed == run.seed) {
    ThrowError(StrCat(at->file.string(), " and ", run.file.string()),
               StrCat("the same sequence, variant and seed ", run.seed), "different runs");
  }
  group->runs.insert(at, std::move(run));
}

std::vector<Group> ReadGroups(const std::vector<TableEntry>& entries) {
  std::vector<Group> groups;
  for (const TableEntry& entry : entries) {
    const std::string name = entry.name.empty() ? entry.result_file.string() : entry.name;
    if (entry.result_file.empty()) {
      groups.push_back({{}, name, "failed", entry.message});
      continue;
    }
    RunSummary run;
    try {
      run = ReadRun(entry.result_file);
    } catch (const Error& error) {
      groups.push_back({{}, name, "unreadable", error.what()});
      continue;
    }
    AddRun(std::move(run), groups);
  }
  return groups;
}

Cell MakeCell(const Group& group, const std::string& metric) {
  Cell cell;
  std::vector<double> values;
  for (const RunSummary& run : group.runs) {
    const MetricValue* found = FindMetric(run, metric);
    if (found == nullptr) continue;
    values.push_back(found->value);
    cell.n += found->n;
    const auto left_out = found->contract.find("left_out");
    if (left_out != found->contract.end()) cell.left_out = left_out->second;
  }
  if (values.size() < group.runs.size() || values.empty()) {
    const bool none = values.empty();
    cell = {};
    cell.message = group.runs.empty() ? "no result"
                   : none             ? "not in the result"
                                      : "not in the results of all seeds";
    return cell;
  }
  cell.present = true;
  for (const double value : values) cell.value += value / static_cast<double>(values.size());
  if (values.size() > 1) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    cell.interval = {*low, *high, StrCat("least and largest of ", values.size(), " seeds")};
  }
  return cell;
}

std::string Link(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) return file.generic_string();
  return std::filesystem::absolute(file)
      .lexically_proximate(std::filesystem::absolute(folder))
      .generic_string();
}

// The truth of a run's metrics; one that knows none (coverage of a run without truth) says nothing.
std::string Truth(const RunSummary& run) {
  for (const MetricValue& metric : run.metrics) {
    const auto truth = metric.contract.find("truth");
    if (truth != metric.contract.end() && !truth->second.empty()) return truth->second;
  }
  return "";
}

Row MakeRow(const Group& group, const std::vector<Column>& columns, const TableRequest& request) {
  Row row;
  row.sequence.name = group.name;
  row.status = group.status;
  row.message = group.message;
  for (const Column& column : columns) row.cells.push_back(MakeCell(group, column.metric));
  if (group.runs.empty()) return row;
  row.sequence = group.runs[0].sequence;
  row.variant = group.runs[0].variant;
  row.truth = Truth(group.runs[0]);
  row.status = "ok";
  for (const RunSummary& run : group.runs) {
    row.seeds.push_back(run.seed);
    row.links.push_back(Link(run.file, request.folder));
    if (run.status == "ok") continue;
    row.status = run.status;
    row.message = run.message.empty() ? "ended as " + run.status : run.message;
  }
  return row;
}

// What a reader must know to compare a row with others.
void AddCalibrationNotes(const std::vector<const RunSummary*>& runs,
                         std::vector<std::string>& notes) {
  for (const RunSummary* run : runs) {
    if (run->sequence.right_shift_px == 0.0) continue;
    const std::string note =
        StrCat(run->sequence.name, ": calibration corrected, u_right by ",
               run->sequence.right_shift_px, " px; figures of others use it as published");
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
}

// Rows of one variant that were not made alike.
void AddNotes(const std::vector<const RunSummary*>& runs, std::vector<std::string>& notes) {
  const auto add = [&](const RunSummary& a, const RunSummary& b, const char* what) {
    const std::string note = StrCat(b.file.string(), ": ", what, " than in ", a.file.string());
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  };
  for (const RunSummary* run : runs) {
    const auto first = std::find_if(runs.begin(), runs.end(), [run](const RunSummary* other) {
      return other->variant == run->variant;
    });
    if ((*first)->options != run->options) add(**first, *run, "other options");
    if ((*first)->build != run->build) add(**first, *run, "another build of the program");
  }
}

}  // namespace

std::vector<std::string> CameraMetrics() {
  return {"camera_coverage",       "camera_ate",          "camera_rrpe_all_pairs",
          "camera_trpe_all_pairs", "camera_rrpe_1_frame", "camera_trpe_1_frame",
          "camera_t_drift",        "camera_r_drift"};
}

std::vector<std::string> ObjectMetrics() {
  return {
      "camera_ate",         "object_ate",       "object_rrpe_all_pairs", "object_trpe_all_pairs",
      "object_motion_r",    "object_motion_t",  "object_success_10cm",   "object_coverage",
      "object_id_switches", "moving_precision", "moving_recall"};
}

Table MakeTable(const TableRequest& request, const Reference& reference) {
  Require(!request.entries.empty(), "a table needs at least one result, none was given");
  const std::vector<Group> groups = ReadGroups(request.entries);
  std::vector<const RunSummary*> runs;
  for (const Group& group : groups) {
    for (const RunSummary& run : group.runs) runs.push_back(&run);
  }
  Table table;
  table.title = request.title;
  table.columns = MakeColumns(request.metrics, runs);
  for (const Group& group : groups) table.rows.push_back(MakeRow(group, table.columns, request));
  AddCalibrationNotes(runs, table.notes);
  AddNotes(runs, table.notes);
  AddReferenceRows(reference, table);
  return table;
}

bool IsComplete(const Table& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const Row& row) {
    return row.status != "failed" && row.status != "unreadable";
  });
}

}  // namespace cvo::reports
