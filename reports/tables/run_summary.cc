// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/run_summary.h"

#include <algorithm>

#include "reports/tables/json_fields.h"

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
  const Fields contract = fields.Object("contract");
  for (const auto& [key, value] : contract.json().items()) {
    metric.contract[key] = contract.Text(key.c_str());
  }
  return metric;
}

}  // namespace

RunSummary ReadRun(const std::filesystem::path& result_file) {
  const Json json = ReadJson(result_file);
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
  if (fields.Has("options")) run.options = fields.Object("options").json().dump();
  if (fields.Has("build")) run.build = fields.Object("build").Text("identity");
  if (!fields.Has("metrics")) return run;
  for (const Json& metric : fields.Array("metrics")) {
    run.metrics.push_back(ReadMetric({metric, StrCat(fields.where(), ", metrics")}));
  }
  return run;
}

const MetricValue* FindMetric(const RunSummary& run, const std::string& name) {
  const auto found = std::find_if(run.metrics.begin(), run.metrics.end(),
                                  [&](const MetricValue& metric) { return metric.name == name; });
  return found == run.metrics.end() ? nullptr : &*found;
}

}  // namespace cvo::reports
