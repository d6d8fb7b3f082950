// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Times of the runs of a suite, stage by stage.

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/record/run_summary.h"
#include "core/record/suite_runs.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// A column of the table, in processing order, with the stages that it sums.
struct StageColumn {
  const char* name;
  std::vector<std::string> stages;
};
const std::vector<StageColumn> kColumns = {{"decode", {"decode"}},
                                           {"features", {"extract", "match_stereo"}},
                                           {"track", {"track"}},
                                           {"associate", {"associate"}},
                                           {"label", {"label"}},
                                           {"windows", {"window"}},
                                           {"camera solve", {"optimize"}},
                                           {"trace back", {"trace"}},
                                           {"cluster solves", {"optimize_clusters"}}};

constexpr std::array kOwnKeys = {"sequence", "family", "detections", "variant"};

struct TimedRuns {
  std::vector<std::string> keys;
  std::vector<double> clusters = {};  // tracked per frame
  std::vector<double> frames_per_s = {};
  std::vector<std::vector<double>> stages_ms = {};  // [column][run], mean over frames
};

double ClustersPerFrame(const RunDetail& detail) {
  const auto tracked = std::count_if(detail.clusters.begin(), detail.clusters.end(),
                                     [](const ObjectRow& cluster) { return !cluster.predicted(); });
  return static_cast<double>(tracked) /
         static_cast<double>(std::max<std::size_t>(detail.camera.size(), 1));
}

// A stage that the run lacks takes no time.
void AddRun(const fs::path& run_folder, const TimingData& timing, TimedRuns& runs) {
  runs.clusters.push_back(ClustersPerFrame(ReadRunDetail(run_folder)));
  runs.frames_per_s.push_back(timing.frames_per_second);
  runs.stages_ms.resize(kColumns.size());
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    double sum_ms = 0.0;
    for (const std::string& stage : kColumns[i].stages) {
      const auto found = timing.stages.find(stage);
      if (found != timing.stages.end()) sum_ms += found->second.mean_ms;
    }
    runs.stages_ms[i].push_back(sum_ms);
  }
}

std::vector<std::string> RowOf(const TimedRuns& runs) {
  std::vector<std::string> row = runs.keys;
  row.insert(row.end(), {StrCat(runs.frames_per_s.size()), FormatFixed(Median(runs.clusters), 1),
                         FormatFixed(Median(runs.frames_per_s), 1)});
  for (const auto& stage_ms : runs.stages_ms) row.push_back(FormatFixed(Median(stage_ms), 2));
  return row;
}

}  // namespace

SuiteTimes ReadSuiteTimes(const fs::path& folder) {
  const SuitePlan plan = ReadPlan(folder / "plan.json");
  std::vector<std::string> options;
  for (const std::string& key : plan.rows) {
    if (std::find(kOwnKeys.begin(), kOwnKeys.end(), key) == kOwnKeys.end()) options.push_back(key);
  }
  SuiteTimes times;
  std::vector<TimedRuns> groups;
  for (const PlannedRun& run : plan.runs) {
    const fs::path run_folder = folder / "jobs" / run.job;
    if (run.job.empty() || !run.system.empty() || !fs::exists(run_folder / "timing.json")) continue;
    const auto timing = ReadRecord<TimingData>(run_folder / "timing.json");
    AddOnce(StrCat(timing.cpu, ", ", Counted(static_cast<std::size_t>(timing.threads), "thread")),
            times.machines);
    std::vector<std::string> keys = {run.family.empty() ? KeyOf(run, "sequence") : run.family,
                                     KeyOf(run, "detections"), KeyOf(run, "variant")};
    for (const std::string& option : options) keys.push_back(KeyOf(run, option));
    AddRun(run_folder, timing, FindOrAdd(groups, &TimedRuns::keys, {keys}));
  }
  if (groups.empty()) ThrowError(folder.string(), "no run that is done", "at least one");
  std::vector<std::string> header = {"scenes", "detections", "variant"};
  header.insert(header.end(), options.begin(), options.end());
  header.insert(header.end(), {"runs", "clusters per frame", "frames/s"});
  for (const StageColumn& column : kColumns) header.push_back(StrCat(column.name, " [ms]"));
  times.table = {header};
  for (const TimedRuns& group : groups) times.table.push_back(RowOf(group));
  return times;
}

}  // namespace cvo::reports
