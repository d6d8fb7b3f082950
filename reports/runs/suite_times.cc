// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/suite_times.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/record/suite_runs.h"
#include "core/record/timing.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// A column of the table, in processing order, with the stages that it sums.
struct StageColumn {
  std::string_view name;
  std::vector<std::string_view> stages;
};
const std::vector<StageColumn>& Columns() {
  static const std::vector<StageColumn> columns = {{"decode", {"decode"}},
                                                   {"features", {"extract", "match_stereo"}},
                                                   {"track", {"track"}},
                                                   {"associate", {"associate"}},
                                                   {"label", {"label"}},
                                                   {"windows", {"window"}},
                                                   {"camera solve", {"optimize"}},
                                                   {"trace back", {"trace"}},
                                                   {"cluster solves", {"optimize_clusters"}}};
  return columns;
}

constexpr std::array<std::string_view, 4> kOwnKeys = {"sequence", "family", "detections",
                                                      "variant"};

struct TimedRuns {
  std::vector<std::string> keys;
  std::vector<double> clusters;
  std::vector<double> frames_per_s;
  std::vector<std::vector<double>> stages_ms;  // [column][run]
};

std::vector<std::string> KeysOf(const PlannedRun& run, const std::vector<std::string>& options) {
  std::vector<std::string> keys = {run.family.empty() ? KeyOf(run, "sequence") : run.family,
                                   KeyOf(run, "detections"), KeyOf(run, "variant")};
  for (const std::string& option : options) keys.push_back(KeyOf(run, option));
  return keys;
}

double ClustersPerFrame(const fs::path& run_folder) {
  const RunDetail detail = ReadRunDetail(run_folder);
  const auto tracked = std::count_if(detail.clusters.begin(), detail.clusters.end(),
                                     [](const ClusterRow& cluster) { return !cluster.predicted; });
  return static_cast<double>(tracked) /
         static_cast<double>(std::max<std::size_t>(detail.camera.size(), 1));
}

void AddRun(const fs::path& run_folder, const TimingData& timing, TimedRuns& runs) {
  runs.clusters.push_back(ClustersPerFrame(run_folder));
  runs.frames_per_s.push_back(timing.frames_per_second);
  runs.stages_ms.resize(Columns().size());
  for (std::size_t i = 0; i < Columns().size(); ++i) {
    double sum_ms = 0.0;
    for (const std::string_view stage : Columns()[i].stages) {
      const auto found = timing.stages.find(std::string(stage));
      if (found != timing.stages.end()) sum_ms += found->second.mean_ms;
    }
    runs.stages_ms[i].push_back(sum_ms);
  }
}

TimesRow RowOf(const TimedRuns& runs) {
  TimesRow row{
      runs.keys, runs.frames_per_s.size(), Median(runs.clusters), Median(runs.frames_per_s), {}};
  for (const std::vector<double>& samples : runs.stages_ms)
    row.stages_ms.push_back(Median(samples));
  return row;
}

}  // namespace

SuiteTimes ReadSuiteTimes(const fs::path& folder) {
  const SuitePlan plan = ReadPlan(folder / "plan.json");
  SuiteTimes times;
  times.keys = {"scenes", "detections", "variant"};
  std::vector<std::string> options;
  for (const std::string& key : plan.rows) {
    if (std::find(kOwnKeys.begin(), kOwnKeys.end(), key) == kOwnKeys.end()) options.push_back(key);
  }
  times.keys.insert(times.keys.end(), options.begin(), options.end());
  for (const StageColumn& column : Columns()) times.stages.emplace_back(column.name);
  std::vector<TimedRuns> groups;
  for (const PlannedRun& run : plan.runs) {
    const fs::path run_folder = folder / "jobs" / run.job;
    if (run.job.empty() || run.system || !fs::exists(run_folder / "timing.json")) continue;
    const auto timing = ReadRecord<TimingData>(run_folder / "timing.json");
    AddOnce(StrCat(timing.cpu, ", ", Counted(static_cast<std::size_t>(timing.threads), "thread")),
            times.machines);
    AddRun(run_folder, timing,
           FindOrAdd(groups, &TimedRuns::keys, {KeysOf(run, options), {}, {}, {}}));
  }
  if (groups.empty()) ThrowError(folder.string(), "no run that is done", "at least one");
  for (const TimedRuns& group : groups) times.rows.push_back(RowOf(group));
  return times;
}

std::vector<std::vector<std::string>> TimesTable(const SuiteTimes& times) {
  std::vector<std::string> header = times.keys;
  header.insert(header.end(), {"runs", "clusters per frame", "frames/s"});
  for (const std::string& stage : times.stages) header.push_back(stage + " [ms]");
  header.emplace_back("time relative to the variant's first row on the same scene");
  std::vector<std::vector<std::string>> table = {header};
  for (const TimesRow& row : times.rows) {
    const auto first =
        std::find_if(times.rows.begin(), times.rows.end(), [&](const TimesRow& other) {
          return other.keys[0] == row.keys[0] && other.keys[2] == row.keys[2];
        });
    std::vector<std::string>& cells = table.emplace_back(row.keys);
    cells.insert(cells.end(), {StrCat(row.runs), FormatFixed(row.clusters, 1),
                               FormatFixed(row.frames_per_s, 1)});
    for (const double stage_ms : row.stages_ms) cells.push_back(FormatFixed(stage_ms, 2));
    cells.push_back(row.frames_per_s > 0.0 ? FormatFixed(first->frames_per_s / row.frames_per_s, 2)
                                           : "");
  }
  return table;
}

}  // namespace cvo::reports
