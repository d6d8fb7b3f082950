// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

struct MetricMeaning {
  MetricUnit unit = MetricUnit::kOne;
  Contract contract;
  Json stated;  // the contract as written in the file
  std::vector<std::string> inferred;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("unit", self.unit);
    archive.Field("contract", self.contract);
    archive.Field("contract", self.stated);
    archive.Optional("inferred", self.inferred);
  }
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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    if (archive.Has("suite", !self.suite.empty())) {
      archive.Field("suite", self.suite);
    } else {
      archive.Field("sequence", self.sequence);
      archive.Field("first_frame", self.first_frame);
      archive.Field("frames", self.frames);
      archive.Optional("body", self.body);
    }
    archive.Field("system", self.system);
    archive.Optional("truth", self.truth);
    archive.Field("values", self.values);
  }
};

struct SourceInFile : ReferenceSource {
  std::map<std::string, MetricMeaning> metrics;
  std::vector<SystemFigures> figures;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    ReferenceSource::VisitFields(self, archive);
    archive.Optional("pair", self.pair);
    archive.Field("metrics", self.metrics);
    archive.Field("figures", self.figures);
  }
};

struct ReferenceInFile {
  static constexpr int kSchemaVersion = 2;
  static constexpr const char* kKind = "reference";

  std::vector<SourceInFile> sources;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("sources", self.sources);
  }
};

// Rejects unknown fields: a misspelt field would otherwise count as not stated.
void CheckMeaning(const MetricMeaning& meaning, const std::string& where) {
  for (const auto& [field, value] : meaning.stated.items()) {
    if (value.is_null() || !FieldText(meaning.contract, field).empty()) continue;
    ThrowError(where + ", contract", field, "a field of a contract");
  }
}

void AddFigures(const SystemFigures& figures, const SourceInFile& source, const std::string& where,
                Reference& reference) {
  for (const auto& [metric, value] : figures.values) {
    const auto meaning = source.metrics.find(metric);
    if (meaning == source.metrics.end()) {
      ThrowError(where + ", values", metric, "one of the metrics of its source");
    }
    ReferenceFigure figure{.source = reference.sources.size(),
                           .sequence = figures.sequence,
                           .body = figures.body,
                           .suite = figures.suite,
                           .first_frame = figures.first_frame,
                           .frames = figures.frames,
                           .system = figures.system,
                           .metric = metric,
                           .value = value,
                           .unit = meaning->second.unit,
                           .contract = meaning->second.contract,
                           .inferred = meaning->second.inferred};
    if (figures.truth) figure.contract.truth = figures.truth;
    // Authors who correct a calibration say so; if they say nothing, there is no correction.
    if (!figure.contract.right_shift_px) figure.contract.right_shift_px = 0.0;
    reference.figures.push_back(std::move(figure));
  }
}

ReferenceCell Compare(const ReferenceFigure& figure, const ReferenceSource& source, const Row& row,
                      const Column& column) {
  const Contract ours = WithTruthOf(column.contract, row.truth);
  const SequenceInfo& sequence = *row.sequence;
  if (figure.first_frame != sequence.first_frame || figure.frames != sequence.frames) {
    return {figure.value, Match::kOtherFrames,
            StrCat("frames ", FrameRange(figure.first_frame, figure.frames), ", ours ",
                   FrameRange(sequence.first_frame, sequence.frames))};
  }
  if (!source.pair.empty() && source.pair != sequence.pair) {
    return {figure.value, Match::kOtherImages, source.pair + " images, ours " + sequence.pair};
  }
  const std::string differing =
      NameOf(figure.unit) != column.unit ? "unit" : ContradictingField(figure.contract, ours);
  if (!differing.empty()) return {figure.value, Match::kContractDiffers, differing + " differs"};
  const std::vector<std::string> unstated = UnstatedFields(figure.contract, ours);
  if (!unstated.empty()) {
    return {figure.value, Match::kContractUnknown, "not stated: " + Joined(unstated, ", ")};
  }
  return {figure.value, Match::kMatches,
          figure.inferred.empty() ? "" : "inferred, not stated: " + Joined(figure.inferred, ", ")};
}

ReferenceRow& RowOf(const ReferenceFigure& figure, std::size_t columns,
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
      RowOf(figure, columns.size(), row.reference).cells[i] =
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
      RowOf(figure, table.columns.size(), table.others).cells[i] =
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

void AddReference(std::string_view json, const std::string& where, Reference& reference) {
  for (const SourceInFile& source :
       ReadRecord<ReferenceInFile>(ParseJson(json, where), where).sources) {
    const std::string place = where + ", " + source.id;
    for (const auto& [metric, meaning] : source.metrics) {
      CheckMeaning(meaning, StrCat(place, ", metrics, ", metric));
    }
    for (const SystemFigures& figures : source.figures) {
      AddFigures(figures, source, place + ", figures", reference);
    }
    reference.sources.push_back(source);
  }
}

Reference ShippedReference() {
  Reference reference;
  for (const auto& [name, json] : ShippedReferenceFiles()) AddReference(json, name, reference);
  return reference;
}

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
