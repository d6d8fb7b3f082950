// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/run_summary.h"

#include <algorithm>

#include "reports/results/json_fields.h"
#include "reports/results/json_text.h"

namespace cvo::reports {
namespace {

SequenceInfo ReadSequence(const Fields& fields) {
  SequenceInfo sequence;
  sequence.name = fields.Text("name");
  sequence.type = fields.Text("type");
  sequence.pair = fields.Text("pair");
  sequence.first_frame = static_cast<int>(fields.Integer("first_frame"));
  sequence.frames = static_cast<int>(fields.Integer("frames"));
  sequence.total_frames = static_cast<int>(fields.Integer("total_frames"));
  if (fields.Has("content")) sequence.content = fields.Text("content");
  if (fields.Has("camera") && fields.Object("camera").Has("right_shift_px")) {
    sequence.right_shift_px = fields.Object("camera").Number("right_shift_px");
  }
  return sequence;
}

MetricValue ReadMetric(const Fields& fields) {
  MetricValue metric;
  metric.name = fields.Text("name");
  metric.value = fields.Number("value");
  metric.unit = fields.Text("unit");
  metric.n = fields.Integer("n");
  metric.contract = fields.NamedTexts("contract");
  return metric;
}

std::vector<MetricValue> ReadMetrics(std::string_view array, const std::string& where,
                                     const std::vector<std::string>& wanted) {
  std::vector<MetricValue> metrics;
  for (const std::string_view element : JsonElements(array, where)) {
    const std::string_view name = FindMember(JsonMembers(element, where), "name");
    const bool is_wanted = std::any_of(wanted.begin(), wanted.end(), [&](const std::string& w) {
      return name.size() == w.size() + 2 && name.substr(1, w.size()) == w;
    });
    if (is_wanted) metrics.push_back(ReadMetric({ParseJson(element, where), where}));
  }
  return metrics;
}

FrameErrors ReadErrors(const Fields& fields) {
  FrameErrors errors;
  for (const Json& frame : fields.Array("frames")) errors.frames.push_back(frame.get<int>());
  for (const Json& error : fields.Array("position_m")) {
    errors.position_m.push_back(error.get<double>());
  }
  if (errors.frames.size() != errors.position_m.size() ||
      !std::is_sorted(errors.frames.begin(), errors.frames.end())) {
    ThrowError(fields.where(),
               StrCat(errors.frames.size(), " frames and ", errors.position_m.size(), " errors"),
               "one error per frame, frames ascending");
  }
  return errors;
}

BodyResult ReadBody(const Fields& fields) {
  BodyResult body;
  body.id = static_cast<int>(fields.Integer("id"));
  body.mover = fields.Bool("mover");
  for (const auto& [key, value] : fields.json().items()) {
    if (value.is_number()) body.values[key] = value.get<double>();
  }
  body.errors = ReadErrors(fields.Object("errors"));
  body.predicted = ReadErrors(fields.Object("predicted"));
  return body;
}

std::vector<BodyResult> ReadBodies(std::string_view array, const std::string& where) {
  std::vector<BodyResult> bodies;
  if (array.empty() || array == "null") return bodies;
  const Json json = ParseJson(array, where);
  if (!json.is_array()) ThrowError(where, StrCat("a JSON ", json.type_name()), "an array");
  for (const Json& body : json) bodies.push_back(ReadBody({body, where}));
  return bodies;
}

bool AnyStartsWith(const std::vector<std::string>& names, const char* prefix, bool starts = true) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return name.starts_with("object_") && name.starts_with(prefix) == starts;
  });
}

void ReadBodyLists(std::string_view bodies, const std::string& where,
                   const std::vector<std::string>& wanted, RunSummary& run) {
  constexpr char kCausal[] = "object_causal_";
  if (bodies.empty() || bodies == "null") return;
  const auto lists = JsonMembers(bodies, where);
  if (AnyStartsWith(wanted, kCausal, false)) {
    run.refined = ReadBodies(FindMember(lists, "refined"), where + ", bodies, refined");
  }
  if (AnyStartsWith(wanted, kCausal)) {
    run.causal = ReadBodies(FindMember(lists, "causal"), where + ", bodies, causal");
  }
}

// The members that are small, parsed.
Json ParseSmall(const std::vector<JsonMember>& members, const std::string& where) {
  Json json = Json::object();
  for (const char* key : {"schema_version", "kind", "job", "status", "message", "variant", "seed",
                          "sequence", "build"}) {
    const std::string_view value = FindMember(members, key);
    if (!value.empty()) json[key] = ParseJson(value, where);
  }
  return json;
}

}  // namespace

RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics) {
  const std::string text = ReadText(result_file);
  const std::vector<JsonMember> members = JsonMembers(text, result_file.string());
  const Json json = ParseSmall(members, result_file.string());
  const Fields fields(json, result_file.string());
  CheckSchema(fields, kRunSchemaVersion);
  if (fields.Text("kind") != "run") {
    ThrowError(fields.where(), StrCat("kind \"", fields.Text("kind"), "\""), "\"run\"");
  }
  RunSummary run;
  run.file = result_file;
  run.job = fields.Text("job");
  run.variant = fields.Text("variant");
  run.seed = static_cast<std::uint64_t>(fields.Integer("seed"));
  run.status = fields.Text("status");
  run.message = fields.Has("message") ? fields.Text("message") : "";
  run.sequence = ReadSequence(fields.Object("sequence"));
  run.options = FindMember(members, "options");
  if (fields.Has("build")) run.build = fields.Object("build").Text("identity");
  const std::string_view values = FindMember(members, "metrics");
  if (values.empty()) return run;
  run.metrics = ReadMetrics(values, fields.where() + ", metrics", metrics);
  ReadBodyLists(FindMember(members, "bodies"), fields.where(), metrics, run);
  return run;
}

const MetricValue* FindMetric(const RunSummary& run, const std::string& name) {
  const auto found = std::find_if(run.metrics.begin(), run.metrics.end(),
                                  [&](const MetricValue& metric) { return metric.name == name; });
  return found == run.metrics.end() ? nullptr : &*found;
}

}  // namespace cvo::reports
