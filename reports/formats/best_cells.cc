// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/best_cells.h"

#include <algorithm>
#include <map>
#include <set>

#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

bool IdentifiesData(const std::string& key) {
  return key == "sequence" || key == "family" || key == "detections" || key.starts_with("scene.");
}

// Returns the values of the keys that identify the data of a row, and its calibration correction.
std::vector<std::string> DataOf(const Row& row, const std::vector<std::string>& keys) {
  std::vector<std::string> data;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (IdentifiesData(keys[i])) data.push_back(row.keys[i]);
  }
  data.push_back(row.corrections);
  return data;
}

bool SameFrames(const Row& a, const Row& b) {
  return a.sequence && b.sequence && a.sequence->name == b.sequence->name &&
         a.sequence->pair == b.sequence->pair &&
         a.sequence->first_frame == b.sequence->first_frame &&
         a.sequence->frames == b.sequence->frames && a.truth == b.truth;
}

struct Candidate {
  double value = 0.0;
  CellText* text = nullptr;
};

// The candidates for the best cell of one column.
class Contest {
 public:
  void AddResult(const Row& row, const Cell& cell, CellText& text) {
    if (!cell.present || text.grey) return;
    std::set<std::string> scenes;
    for (const std::size_t run : cell.runs) scenes.insert(row.runs[run].sequence);
    if (!candidates_.empty() && scenes != scenes_) same_scenes_ = false;
    scenes_ = std::move(scenes);
    candidates_.push_back({cell.value, &text});
  }
  void AddReferenceValue(const ReferenceCell& cell, CellText& text) {
    if (cell.match == Match::kMatches) candidates_.push_back({cell.value, &text});
  }
  bool Mark(bool higher_is_better) const {
    if (!same_scenes_ || candidates_.size() < 2) return false;
    const auto better = [&](const Candidate& a, const Candidate& b) {
      return higher_is_better ? a.value > b.value : a.value < b.value;
    };
    const std::string best =
        std::min_element(candidates_.begin(), candidates_.end(), better)->text->value;
    const auto is_best = [&](const Candidate& candidate) { return candidate.text->value == best; };
    if (std::all_of(candidates_.begin(), candidates_.end(), is_best)) return false;
    for (const Candidate& candidate : candidates_) {
      if (is_best(candidate)) candidate.text->best = true;
    }
    return true;
  }

 private:
  std::vector<Candidate> candidates_;
  std::set<std::string> scenes_;
  bool same_scenes_ = true;
};

// A row with zero coverage cannot be best, for example for having no identity switches.
bool HasZeroCoverage(const Table& table, const Row& row, std::size_t column) {
  const std::string coverage = CoverageOf(table.columns[column].metric);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].metric == coverage && i != column) {
      return row.cells[i].present && row.cells[i].value == 0.0;
    }
  }
  return false;
}

bool MarkColumn(const Table& table, const std::vector<TextLine*>& lines, std::size_t column,
                bool higher_is_better) {
  Contest contest;
  for (TextLine* line : lines) {
    const Row& row = table.rows[*line->row];
    if (!line->reference) {
      if (HasZeroCoverage(table, row, column)) continue;
      contest.AddResult(row, row.cells[column], line->cells[column]);
    } else if (const auto& cell = row.reference[*line->reference].cells[column]) {
      contest.AddReferenceValue(*cell, line->cells[column]);
    }
  }
  return contest.Mark(higher_is_better);
}

}  // namespace

bool MarkBest(const Table& table, std::vector<TextLine>& lines) {
  std::map<std::vector<std::string>, std::vector<TextLine*>> groups;
  for (TextLine& line : lines) {
    if (!line.row || line.reference) continue;
    groups[DataOf(table.rows[*line.row], table.keys)].push_back(&line);
  }
  bool any = false;
  for (auto& [data, group] : groups) {
    const Row& ours = table.rows[*group[0]->row];
    for (TextLine& line : lines) {
      if (line.row && line.reference && SameFrames(table.rows[*line.row], ours)) {
        group.push_back(&line);
      }
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const MetricEntry* rule = FindEntry(table.columns[i].metric);
      if (rule && MarkColumn(table, group, i, rule->higher_is_better())) any = true;
    }
  }
  return any;
}

}  // namespace cvo::reports
