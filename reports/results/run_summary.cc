// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/run_summary.h"

#include <algorithm>

#include "core/files/json_fields.h"

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

std::vector<MetricValue> ReadMetrics(const Fields& run, const std::vector<std::string>& wanted) {
  std::vector<MetricValue> metrics;
  for (const Json& json : run.Array("metrics")) {
    auto metric = FromJson<MetricValue>(json, run.where() + ", metrics");
    if (std::find(wanted.begin(), wanted.end(), metric.name) != wanted.end()) {
      metrics.push_back(std::move(metric));
    }
  }
  return metrics;
}

void CheckErrors(const FrameErrors& errors, const std::string& where) {
  if (errors.frames.size() != errors.position_m.size() ||
      !std::is_sorted(errors.frames.begin(), errors.frames.end())) {
    ThrowError(where,
               StrCat(errors.frames.size(), " frames and ", errors.position_m.size(), " errors"),
               "one error per frame, frames ascending");
  }
}

std::vector<BodyRow> ReadBodies(const Fields& lists, const char* key) {
  const std::string where = StrCat(lists.where(), ", ", key);
  auto bodies = FromJson<std::vector<BodyRow>>(lists.Array(key), where);
  for (const BodyRow& body : bodies) {
    CheckErrors(body.errors, where + ", errors");
    CheckErrors(body.predicted, where + ", predicted");
  }
  return bodies;
}

}  // namespace

RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics) {
  // Most of a result is poses, which are for others to read.
  const Json json = ReadJson(result_file, {"clusters", "frames", "trajectories"});
  const Fields fields(json, result_file.string());
  fields.Check(kRunSchemaVersion, "run");
  RunSummary run;
  run.file = result_file;
  run.job = fields.Text("job");
  run.variant = fields.Text("variant");
  run.seed = fields.Count("seed");
  run.status = fields.Text("status");
  run.message = fields.TextOr("message", "");
  run.sequence = ReadSequence(fields.Object("sequence"));
  if (fields.Has("options")) run.options = fields.Object("options").json().dump();
  if (fields.Has("build")) {
    run.build = fields.Object("build").Text("identity");
    run.commit = fields.Object("build").TextOr("commit", "");
    run.cpu_level = fields.Object("build").TextOr("cpu_level", "");
  }
  if (fields.Has("metrics")) run.metrics = ReadMetrics(fields, metrics);
  if (fields.Has("bodies") && !json["bodies"].is_null()) {
    const Fields bodies = fields.Object("bodies");
    run.refined = ReadBodies(bodies, "refined");
    run.causal = ReadBodies(bodies, "causal");
  }
  return run;
}

const MetricValue* FindMetric(const RunSummary& run, const std::string& name) {
  const auto found = std::find_if(run.metrics.begin(), run.metrics.end(),
                                  [&](const MetricValue& metric) { return metric.name == name; });
  return found == run.metrics.end() ? nullptr : &*found;
}

}  // namespace cvo::reports
