// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/reference.h"

#include <map>

#include "core/files/json_fields.h"
#include "reports/reference/shipped.h"

namespace cvo::reports {
namespace {

constexpr int kReferenceSchemaVersion = 1;

struct MetricMeaning {
  std::string unit;
  Contract contract;
  std::vector<std::string> inferred;
};

MetricMeaning ReadMeaning(const Fields& fields) {
  MetricMeaning meaning;
  meaning.unit = fields.Text("unit");
  const Fields contract = fields.Object("contract");
  for (const auto& [key, value] : contract.json().items()) {
    meaning.contract[key] = value.is_null() ? "" : contract.Text(key.c_str());
  }
  if (!fields.Has("inferred")) return meaning;
  for (const Json& field : fields.Array("inferred")) {
    meaning.inferred.push_back(field.get<std::string>());
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
    if (fields.Has("truth")) figure.contract["truth"] = fields.Text("truth");
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
