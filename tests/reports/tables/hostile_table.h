// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::test {

inline const char kScript[] = "<script>alert(\"1\")</script>";
inline const char kLatex[] = "a_b%c&d#e$f{g}~h^i\\j--k";
inline const char kFormula[] = "=cmd|' /C calc'!A0";
inline const char kQuoted[] = "x,\"y\"\nz \x1b[31m";

inline reports::Cell CellOf(double value, double low, double high) {
  reports::Cell cell;
  cell.value = value;
  cell.n = {2, 1, 0, 2};
  cell.interval = reports::Interval{low, high};
  return cell;
}

inline reports::Cell MissingCell() {
  reports::Cell cell;
  cell.message = "no value in any run, <i>not</i> 100 % & more";
  return cell;
}

inline reports::Row RowOf(const std::string& sequence, const std::string& variant) {
  reports::Row row;
  row.keys = {sequence, variant};
  row.sequence = reports::SequenceInfo{sequence, "kitti-raw", "grey", 0, 72, 72};
  row.truth.truth = reports::TruthSource::kDevkit;
  row.jobs.planned = 2;
  row.jobs.done = 2;
  row.runs = {{sequence, 1, "jobs/a/result.json"}, {sequence, 2, "jobs/b/result.json"}};
  return row;
}

// Appends one row with a reference figure for each kind of match on the same scene.
inline void AddReferences(reports::Row& row) {
  using reports::Match;
  const auto add = [&row](const std::string& system, double value, Match match,
                          const std::string& reason) {
    row.reference.push_back({"p", system, 0, 72, {{"camera_ate", "m", value, match, reason}}});
  };
  add("Same & co", 0.01, Match::kMatches, "inferred, not stated: poses");
  add("Frames", 0.02, Match::kOtherFrames, "frames 0:144, ours 0:72");
  add("Images", 0.03, Match::kOtherImages, "colour images, ours grey");
  add("Unknown", 0.04, Match::kContractUnknown, "not stated: alignment");
  add("Differs <b>", 0.005, Match::kContractDiffers, "alignment differs");
}

// A table with names that would be code in HTML, LaTeX, CSV or a terminal, missing cells, failed
// jobs, another system, and reference figures of every kind of match.
inline reports::Table HostileTable() {
  reports::Table table;
  table.title = "Suite <b>&amp;</b> 50 %";
  table.about = "- about [a link](javascript:alert(1)) | and `code`";
  table.reference = "full";
  table.keys = {"sequence", "variant"};
  table.columns = {{"camera_coverage", "camera coverage", "1", {}},
                   {"camera_ate", "camera ATE", "m", {}},
                   {"object_coverage", "object coverage", "1", {}},
                   {"object_ate", "object ATE", "m", {}},
                   {"object_id_switches", "id switches", "1", {}}};
  table.columns[1].contract.aggregation = reports::Aggregation::kRmsOfPositions;
  table.columns[1].contract.delta = reports::Delta::kNone;
  table.columns[3].contract.alignment = reports::Alignment::kWorld;
  reports::Row full = RowOf(kScript, "full");
  full.cells = {CellOf(1.0, 1.0, 1.0), CellOf(0.0612, 0.05, 0.07), CellOf(0.9, 0.8, 0.95),
                CellOf(0.05761, 0.034, 0.085), CellOf(2.0, 1.0, 3.0)};
  reports::Row ablation = RowOf(kScript, kLatex);
  ablation.cells = {CellOf(1.0, 1.0, 1.0), CellOf(0.0712, 0.06, 0.08), CellOf(0.7, 0.6, 0.75),
                    CellOf(0.10432, 0.061, 0.16), MissingCell()};
  ablation.cells[3].n.bodies = 11;
  ablation.cells[3].left_out = "1 of 12 bodies (of all runs) without a value";
  reports::Difference difference;
  difference.value = 0.104;
  difference.reference_value = 0.057;
  difference.difference = 0.0467;
  difference.interval = reports::Interval{0.0112, 0.0874};
  difference.percent = 81.0;
  difference.distinguishable = true;
  difference.pairs = 11;
  ablation.cells[3].difference = difference;
  reports::Row system = RowOf(kScript, "their\tsystem");
  system.cells = {CellOf(1.0, 1.0, 1.0), CellOf(0.001, 0.0009, 0.0012), MissingCell(),
                  MissingCell(), MissingCell()};
  system.cells[1].not_comparable = "delta \"1 frame\"";
  AddReferences(system);
  reports::Row other = RowOf(kFormula, kQuoted);
  other.cells.assign(5, MissingCell());
  other.sequence.reset();
  other.truth = {};
  other.runs.clear();
  other.jobs = {3, 0, 0, 2, 1, 0};
  table.rows = {full, ablation, system, other};
  table.others = {{"q",
                   "Rooms",
                   0,
                   0,
                   {{"object_ate", "m", 0.5, reports::Match::kOtherScenes, "other scenes"}}}};
  table.sources = {{"p", "a paper (CVPR <2020>) table_2", "published", "a caveat: 50 %", ""},
                   {"q", "another paper", "published", "", ""}};
  table.jobs = {9, 6, 1, 2, 1, 0};
  table.problems = {{kFormula, kFormula, 1, "failed", "killed <i>by</i> signal 9", "logs/x.log"},
                    {kFormula, kFormula, 2, "failed", "half_written & gone", ""}};
  table.notes = {"results come from 2 builds of the program: run the suite again to have one"};
  table.provenance = {{"abc", "def"},
                      {1, 2},
                      {{"orb.features", "2000", {"1999", "1500"}}, {"new.option", "", {"[1,2]"}}}};
  return table;
}

}  // namespace cvo::test
