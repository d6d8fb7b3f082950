// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/reference.h"

#include <map>

#include "core/files/json_fields.h"
#include "reports/reference/shipped.h"

namespace cvo::reports {
namespace {

constexpr int kReferenceSchemaVersion = 2;

struct MetricMeaning {
  MetricUnit unit = MetricUnit::kOne;
  Contract contract;
  std::vector<std::string> inferred;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("unit", self.unit);
    archive.Field("contract", self.contract);
    archive.Optional("inferred", self.inferred);
  }
};

// A misspelt field would be one that is not stated.
MetricMeaning ReadMeaning(const Fields& fields) {
  const auto meaning = FromJson<MetricMeaning>(fields.json(), fields.where());
  for (const auto& [field, value] : fields.Object("contract").json().items()) {
    if (value.is_null() || !FieldText(meaning.contract, field).empty()) continue;
    ThrowError(fields.where() + ", contract", field, "a field of a contract");
  }
  return meaning;
}

void AddFigures(const Fields& fields, const std::map<std::string, MetricMeaning>& meanings,
                std::size_t source, std::vector<ReferenceFigure>& figures) {
  const Fields values = fields.Object("values");
  for (const auto& [metric, value] : values.json().items()) {
    const auto meaning = meanings.find(metric);
    if (meaning == meanings.end()) {
      ThrowError(values.where(), metric, "one of the metrics of its source");
    }
    ReferenceFigure figure;
    figure.source = source;
    if (fields.Has("suite")) {
      figure.suite = fields.Text("suite");
    } else {
      figure.sequence = fields.Text("sequence");
      figure.first_frame = static_cast<int>(fields.Integer("first_frame"));
      figure.frames = static_cast<int>(fields.Integer("frames"));
    }
    figure.system = fields.Text("system");
    figure.metric = metric;
    figure.value = values.Number(metric.c_str());
    figure.unit = meaning->second.unit;
    figure.contract = meaning->second.contract;
    figure.inferred = meaning->second.inferred;
    if (fields.Has("truth")) {
      figure.contract.truth =
          FromJson<TruthSource>(fields.Text("truth"), fields.where() + ", field truth");
    }
    // Who corrects a calibration says so.
    if (!figure.contract.right_shift_px) figure.contract.right_shift_px = 0.0;
    figures.push_back(std::move(figure));
  }
}

void AddSource(const Fields& fields, Reference& reference) {
  ReferenceSource source;
  source.id = fields.Text("id");
  source.source = fields.Text("source");
  source.kind = fields.Text("kind");
  source.caveat = fields.Text("caveat");
  if (fields.Has("pair")) source.pair = fields.Text("pair");
  std::map<std::string, MetricMeaning> meanings;
  const Fields metrics = fields.Object("metrics");
  for (const auto& [metric, value] : metrics.json().items()) {
    meanings[metric] = ReadMeaning(metrics.Object(metric.c_str()));
  }
  for (const Json& figure : fields.Array("figures")) {
    AddFigures({figure, StrCat(fields.where(), ", ", source.id, ", figures")}, meanings,
               reference.sources.size(), reference.figures);
  }
  reference.sources.push_back(std::move(source));
}

}  // namespace

void AddReference(std::string_view json, const std::string& where, Reference& reference) {
  const Json parsed = ParseJson(json, where);
  const Fields fields(parsed, where);
  fields.CheckSchema(kReferenceSchemaVersion);
  for (const Json& source : fields.Array("sources")) AddSource({source, where}, reference);
}

Reference ShippedReference() {
  Reference reference;
  for (const ReferenceFile& file : ShippedReferenceFiles()) {
    AddReference(file.content, file.name, reference);
  }
  return reference;
}

}  // namespace cvo::reports
