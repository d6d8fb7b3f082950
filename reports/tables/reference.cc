// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/reference.h"

#include <map>

#include "core/files/json/json_record.h"
#include "reports/reference/shipped.h"

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
  for (const ReferenceFile& file : ShippedReferenceFiles()) {
    AddReference(file.content, file.name, reference);
  }
  return reference;
}

}  // namespace cvo::reports
