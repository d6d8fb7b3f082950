// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/run_summary.h"

#include <algorithm>

namespace cvo::reports {
namespace {

void CheckErrors(const FrameErrors& errors, const std::string& where) {
  if (errors.frames.size() != errors.position_m.size() ||
      !std::is_sorted(errors.frames.begin(), errors.frames.end())) {
    ThrowError(where,
               StrCat(errors.frames.size(), " frames and ", errors.position_m.size(), " errors"),
               "one error per frame, frames ascending");
  }
}

void CheckBodies(const std::vector<BodyRow>& bodies, const std::string& where) {
  for (const BodyRow& body : bodies) {
    CheckErrors(body.errors, where + ", errors");
    CheckErrors(body.predicted, where + ", predicted");
  }
}

}  // namespace

RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics) {
  // Most of a result is poses, which are for others to read.
  auto run = ReadRecord<RunSummary>(result_file, {"clusters", "frames", "trajectories"});
  run.file = result_file;
  std::erase_if(run.metrics, [&](const MetricValue& metric) {
    return std::find(metrics.begin(), metrics.end(), metric.name) == metrics.end();
  });
  if (run.bodies) {
    CheckBodies(run.bodies->refined, result_file.string() + ", bodies, refined");
    CheckBodies(run.bodies->causal, result_file.string() + ", bodies, causal");
  }
  return run;
}

const MetricValue* FindMetric(const RunSummary& run, const std::string& name) {
  const auto found = std::find_if(run.metrics.begin(), run.metrics.end(),
                                  [&](const MetricValue& metric) { return metric.name == name; });
  return found == run.metrics.end() ? nullptr : &*found;
}

}  // namespace cvo::reports
