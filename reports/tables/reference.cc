// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

struct MetricMeaning {
  MetricUnit unit = MetricUnit::kOne;
  Json contract;
  std::vector<std::string> inferred;

  CVO_RECORD(CVO_FIELD(unit, contract) CVO_OPTIONAL(inferred));
};

// What one system reaches on some frames, or for a suite.
struct SystemFigures {
  std::string suite;
  std::string sequence;
  std::string body;
  int first_frame = 0;
  int frames = 0;
  std::string system;
  std::optional<TruthSource> truth;
  std::map<std::string, double> values;

  CVO_RECORD(CVO_OPTIONAL(suite, sequence, body, first_frame, frames) CVO_FIELD(system)
                 CVO_OPTIONAL(truth) CVO_FIELD(values));
};

struct SourceInFile : ReferenceSource {
  std::map<std::string, MetricMeaning> metrics;
  std::vector<SystemFigures> figures;

  CVO_RECORD(ReferenceSource::VisitFields(self, archive);
             CVO_OPTIONAL(pair) CVO_FIELD(metrics, figures));
};

struct ReferenceInFile {
  static constexpr int kSchemaVersion = 2;
  static constexpr const char* kKind = "reference";

  std::vector<SourceInFile> sources;

  CVO_FIELDS(sources);
};

// Rejects unknown fields: a misspelt field would otherwise count as not stated.
Contract ContractOf(const MetricMeaning& meaning, const std::string& where) {
  const auto contract = FromJson<Contract>(meaning.contract, where);
  for (const auto& [field, value] : meaning.contract.items()) {
    if (value.is_null() || !FieldText(contract, field).empty()) continue;
    ThrowError(where, field, "a field of a contract");
  }
  return contract;
}

void AddFigures(const SystemFigures& figures, const SourceInFile& source, const std::string& where,
                Reference& reference) {
  for (const auto& [metric, value] : figures.values) {
    const auto meaning = source.metrics.find(metric);
    if (meaning == source.metrics.end()) {
      ThrowError(where + ", figures, values", metric, "one of the metrics of its source");
    }
    ReferenceFigure figure{
        .source = source,
        .sequence = figures.sequence,
        .body = figures.body,
        .suite = figures.suite,
        .first_frame = figures.first_frame,
        .frames = figures.frames,
        .system = figures.system,
        .metric = metric,
        .value = value,
        .unit = meaning->second.unit,
        .contract = ContractOf(meaning->second, StrCat(where, ", metrics, ", metric, ", contract")),
        .inferred = meaning->second.inferred};
    if (figures.truth) figure.contract.truth = figures.truth;
    // Authors who correct a calibration say so; if they say nothing, there is no correction.
    if (!figure.contract.right_shift_px) figure.contract.right_shift_px = 0.0;
    reference.push_back(std::move(figure));
  }
}

// Whether a figure is comparable with ours, and if not, why.
std::pair<Match, std::string> Compare(const ReferenceFigure& figure, const Row& row,
                                      const Column& column) {
  const Contract ours = WithTruthOf(column.contract, row.truth);
  const SequenceInfo& sequence = *row.sequence;
  if (figure.first_frame != sequence.first_frame || figure.frames != sequence.frames) {
    return {Match::kOtherFrames,
            StrCat("frames ", FrameRange(figure.first_frame, figure.frames), ", ours ",
                   FrameRange(sequence.first_frame, sequence.frames))};
  }
  const std::string& pair = figure.source.pair;
  if (!pair.empty() && pair != sequence.pair) {
    return {Match::kOtherImages, pair + " images, ours " + sequence.pair};
  }
  const std::string differing =
      NameOf(figure.unit) != column.unit ? "unit" : ContradictingField(figure.contract, ours);
  if (!differing.empty()) return {Match::kContractDiffers, differing + " differs"};
  const std::vector<std::string> unstated = UnstatedFields(figure.contract, ours);
  if (!unstated.empty()) {
    return {Match::kContractUnknown, "not stated: " + Joined(unstated, ", ")};
  }
  return {Match::kMatches,
          figure.inferred.empty() ? "" : "inferred, not stated: " + Joined(figure.inferred, ", ")};
}

void AddCell(const ReferenceFigure& figure, const Column& column,
             const std::pair<Match, std::string>& match, std::vector<ReferenceRow>& rows) {
  const ReferenceRow fresh{figure.source.id, figure.system, figure.first_frame, figure.frames};
  const auto same = [](const ReferenceRow& row) {
    return std::tuple(row.source, row.system, row.first_frame, row.frames);
  };
  const ReferenceCell cell{figure.metric, column.unit, figure.value, match.first, match.second};
  FindOrAdd(FindOrAdd(rows, same, fresh).cells, &ReferenceCell::metric, cell) = cell;
}

bool HasMatch(const ReferenceRow& row) {
  return FindBy(row.cells, &ReferenceCell::match, Match::kMatches) != nullptr;
}

// Adds the sources of these rows, in the order of their first use.
void AddSources(const std::vector<ReferenceRow>& rows, const Reference& reference, Table& table) {
  const auto id = [](const ReferenceFigure& figure) { return figure.source.id; };
  for (const ReferenceRow& row : rows) {
    FindOrAdd(table.sources, &ReferenceSource::id, FindBy(reference, id, row.source)->source);
  }
}

}  // namespace

void AddReference(std::string_view json, const std::string& where, Reference& reference) {
  for (const SourceInFile& source :
       ReadRecord<ReferenceInFile>(ParseJson(json, where), where).sources) {
    for (const SystemFigures& figures : source.figures) {
      AddFigures(figures, source, where + ", " + source.id, reference);
    }
  }
}

Reference ShippedReference() {
  Reference reference;
  for (const auto& [name, json] : ShippedReferenceFiles()) AddReference(json, name, reference);
  return reference;
}

void AddReferenceRows(const Reference& reference, Table& table) {
  std::map<std::string, Row*> last;  // references of a sequence are shown once, below its last row
  for (Row& row : table.rows) {
    if (!row.sequence) continue;
    const SequenceInfo& sequence = *row.sequence;
    last[StrCat(sequence.name, "/", sequence.pair, "/", sequence.first_frame, "/", sequence.frames,
                "/", row.corrections)] = &row;
  }
  for (Row& row : table.rows) {
    const bool shows = std::any_of(last.begin(), last.end(),
                                   [&](const auto& shown) { return shown.second == &row; });
    for (const ReferenceFigure& figure : reference) {
      const Column* column = FindBy(table.columns, &Column::metric, figure.metric);
      if (!shows || column == nullptr || !figure.body.empty()) continue;
      if (figure.sequence != row.sequence->name) continue;
      AddCell(figure, *column, Compare(figure, row, *column), row.reference);
    }
    std::stable_partition(row.reference.begin(), row.reference.end(), HasMatch);
    AddSources(row.reference, reference, table);
  }
  // The values for a whole suite of other scenes are never comparable, only their order is.
  for (const ReferenceFigure& figure : reference) {
    const Column* column = FindBy(table.columns, &Column::metric, figure.metric);
    if (column == nullptr || figure.suite.empty() || !table.title.starts_with(figure.suite))
      continue;
    AddCell(figure, *column, {Match::kOtherScenes, "other scenes"}, table.others);
  }
  AddSources(table.others, reference, table);
}

}  // namespace cvo::reports
