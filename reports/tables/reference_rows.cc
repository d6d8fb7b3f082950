// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/reference_rows.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

ReferenceCell Compare(const ReferenceFigure& figure, const ReferenceSource& source, const Row& row,
                      const Column& column) {
  const Contract ours = WithTruthOf(column.contract, row.truth);
  const SequenceInfo& sequence = *row.sequence;
  if (figure.first_frame != sequence.first_frame || figure.frames != sequence.frames) {
    return {figure.value, Match::kOtherFrames,
            StrCat("frames ", figure.first_frame, ":", figure.first_frame + figure.frames,
                   ", ours ", sequence.first_frame, ":", sequence.first_frame + sequence.frames)};
  }
  if (!source.pair.empty() && source.pair != sequence.pair) {
    return {figure.value, Match::kOtherImages, source.pair + " images, ours " + sequence.pair};
  }
  const std::string differing =
      NameOf(figure.unit) != column.unit ? "unit" : ContradictingField(figure.contract, ours);
  if (!differing.empty()) return {figure.value, Match::kContractDiffers, differing + " differs"};
  std::string unstated;
  for (const std::string& field : UnstatedFields(figure.contract, ours)) {
    unstated += (unstated.empty() ? "not stated: " : ", ") + field;
  }
  if (!unstated.empty()) return {figure.value, Match::kContractUnknown, unstated};
  std::string inferred;
  for (const std::string& field : figure.inferred) {
    inferred += (inferred.empty() ? "inferred, not stated: " : ", ") + field;
  }
  return {figure.value, Match::kMatches, inferred};
}

ReferenceRow& FindOrAdd(const ReferenceFigure& figure, std::size_t columns,
                        std::vector<ReferenceRow>& rows) {
  for (ReferenceRow& other : rows) {
    if (other.source == figure.source && other.system == figure.system &&
        other.first_frame == figure.first_frame && other.frames == figure.frames) {
      return other;
    }
  }
  rows.push_back({figure.source, figure.system, figure.first_frame, figure.frames, {}});
  rows.back().cells.resize(columns);
  return rows.back();
}

bool HasMatch(const ReferenceRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(), [](const auto& cell) {
    return cell.has_value() && cell->match == Match::kMatches;
  });
}

void AddToRow(const Reference& reference, const std::vector<Column>& columns, Row& row) {
  for (const ReferenceFigure& figure : reference.figures) {
    if (figure.sequence != row.sequence->name || !figure.body.empty()) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].metric != figure.metric) continue;
      FindOrAdd(figure, columns.size(), row.reference).cells[i] =
          Compare(figure, reference.sources[figure.source], row, columns[i]);
    }
  }
  std::stable_partition(row.reference.begin(), row.reference.end(), HasMatch);
}

// Adds the figures for a whole suite of other scenes. Their values are never comparable, only their
// order is.
void AddToTable(const Reference& reference, Table& table) {
  for (const ReferenceFigure& figure : reference.figures) {
    if (figure.suite.empty() || !table.title.starts_with(figure.suite)) continue;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.columns[i].metric != figure.metric) continue;
      FindOrAdd(figure, table.columns.size(), table.others).cells[i] =
          ReferenceCell{figure.value, Match::kOtherScenes, "other scenes"};
    }
  }
}

// Keeps only the sources that a row refers to, in the order of their first use.
void KeepUsedSources(const Reference& reference, Table& table) {
  std::vector<std::size_t> used;
  const auto keep = [&](std::vector<ReferenceRow>& lines) {
    for (ReferenceRow& line : lines) {
      const auto found = std::find(used.begin(), used.end(), line.source);
      const auto index = static_cast<std::size_t>(found - used.begin());
      if (found == used.end()) {
        used.push_back(line.source);
        table.sources.push_back(reference.sources[line.source]);
      }
      line.source = index;
    }
  };
  for (Row& row : table.rows) keep(row.reference);
  keep(table.others);
}

}  // namespace

void AddReferenceRows(const Reference& reference, Table& table) {
  std::vector<std::string> seen;  // references of a sequence are shown once, below its last row
  for (auto row = table.rows.rbegin(); row != table.rows.rend(); ++row) {
    if (!row->sequence) continue;
    const SequenceInfo& sequence = *row->sequence;
    const std::string key = StrCat(sequence.name, "/", sequence.pair, "/", sequence.first_frame,
                                   "/", sequence.frames, "/", row->corrections);
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) continue;
    seen.push_back(key);
    AddToRow(reference, table.columns, *row);
  }
  AddToTable(reference, table);
  KeepUsedSources(reference, table);
}

}  // namespace cvo::reports
