// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/reference_rows.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

ReferenceCell Compare(const ReferenceFigure& figure, const ReferenceSource& source, const Row& row,
                      const Column& column) {
  Contract ours = column.contract;
  ours["truth"] = row.truth;
  const SequenceInfo& sequence = row.sequence;
  if (figure.first_frame != sequence.first_frame || figure.frames != sequence.frames) {
    return {figure.value, Match::kOtherFrames,
            StrCat("frames ", figure.first_frame, ":", figure.first_frame + figure.frames,
                   ", ours ", sequence.first_frame, ":", sequence.first_frame + sequence.frames)};
  }
  if (!source.pair.empty() && source.pair != sequence.pair) {
    return {figure.value, Match::kOtherImages, source.pair + " images, ours " + sequence.pair};
  }
  const std::string differing =
      figure.unit != column.unit ? "unit" : DifferingField(figure.contract, ours);
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

ReferenceRow& FindOrAdd(const ReferenceFigure& figure, std::size_t columns, Row& row) {
  for (ReferenceRow& other : row.reference) {
    if (other.source == figure.source && other.system == figure.system &&
        other.first_frame == figure.first_frame && other.frames == figure.frames) {
      return other;
    }
  }
  row.reference.push_back({figure.source, figure.system, figure.first_frame, figure.frames, {}});
  row.reference.back().cells.resize(columns);
  return row.reference.back();
}

bool HasMatch(const ReferenceRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(), [](const auto& cell) {
    return cell.has_value() && cell->match == Match::kMatches;
  });
}

void AddToRow(const Reference& reference, const std::vector<Column>& columns, Row& row) {
  for (const ReferenceFigure& figure : reference.figures) {
    if (figure.sequence != row.sequence.name) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].metric != figure.metric) continue;
      FindOrAdd(figure, columns.size(), row).cells[i] =
          Compare(figure, reference.sources[figure.source], row, columns[i]);
    }
  }
  std::stable_partition(row.reference.begin(), row.reference.end(), HasMatch);
}

// Keeps the sources that a row refers to, in the order of their first use.
void KeepUsedSources(const Reference& reference, Table& table) {
  std::vector<std::size_t> used;
  for (Row& row : table.rows) {
    for (ReferenceRow& line : row.reference) {
      const auto found = std::find(used.begin(), used.end(), line.source);
      const auto index = static_cast<std::size_t>(found - used.begin());
      if (found == used.end()) {
        used.push_back(line.source);
        table.sources.push_back(reference.sources[line.source]);
      }
      line.source = index;
    }
  }
}

}  // namespace

const char* ToString(Match match) {
  switch (match) {
    case Match::kMatches:
      return "matches";
    case Match::kOtherFrames:
      return "other frames";
    case Match::kOtherImages:
      return "other images";
    case Match::kContractUnknown:
      return "contract not stated";
    case Match::kContractDiffers:
      return "contract differs";
  }
  throw Error("Match: not one of the enumerators");
}

void AddReferenceRows(const Reference& reference, Table& table) {
  std::vector<std::string> seen;  // a sequence with several variants shows its references once
  for (auto row = table.rows.rbegin(); row != table.rows.rend(); ++row) {
    const SequenceInfo& sequence = row->sequence;
    const std::string key =
        StrCat(sequence.name, "/", sequence.pair, "/", sequence.first_frame, "/", sequence.frames);
    if (row->links.empty() || std::find(seen.begin(), seen.end(), key) != seen.end()) continue;
    seen.push_back(key);
    AddToRow(reference, table.columns, *row);
  }
  KeepUsedSources(reference, table);
}

}  // namespace cvo::reports
