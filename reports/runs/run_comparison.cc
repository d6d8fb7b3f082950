// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_comparison.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text/closest_names.h"
#include "core/record/metric_catalogue.h"
#include "reports/runs/paired_runs.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

RunToCompare ReadOne(const fs::path& folder, std::vector<std::string>& notes) {
  RunToCompare run;
  run.summary = ReadRun(folder / "result.json", AllMetricNames());
  run.name = run.summary.variant;
  run.camera = CameraPositionsOf(ReadRunDetail(folder));
  if (run.camera.frames.empty()) {
    notes.push_back(StrCat(folder.string(), ": no truth of the camera frame by frame"));
  }
  return run;
}

void CheckSameSequence(const std::vector<RunToCompare>& runs) {
  const RunSummary& first = runs.front().summary;
  for (const RunToCompare& run : runs) {
    const RunSequence& sequence = run.summary.sequence;
    if (sequence.name == first.sequence.name) continue;
    ThrowError(run.summary.file.string(), "a run of " + sequence.name,
               StrCat("one of ", first.sequence.name, ", as ", first.file.string()));
  }
}

// Returns, for each run, the options that differ between the runs, with the run's values.
std::vector<std::map<std::string, std::string>> DifferingOptions(
    const std::vector<RunToCompare>& runs) {
  std::vector<std::map<std::string, std::string>> all;
  for (const RunToCompare& run : runs) all.push_back(FlatJson(run.summary.options));
  std::map<std::string, std::map<std::string, std::size_t>> uses;
  for (const auto& options : all) {
    for (const auto& [path, value] : options) ++uses[path][value];
  }
  for (auto& options : all) {
    std::erase_if(options, [&](const auto& option) {
      return uses[option.first][option.second] == runs.size();
    });
  }
  return all;
}

std::vector<ComparedRun> DescribeRuns(const std::vector<RunToCompare>& runs,
                                      const std::vector<fs::path>& folders) {
  const auto options = DifferingOptions(runs);
  std::vector<ComparedRun> described;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunSummary& run = runs[i].summary;
    described.push_back({runs[i].name, folders[i].string(), run.variant, run.seed, run.status,
                         run.sequence.first_frame, run.sequence.frames, run.build.identity,
                         options[i]});
  }
  return described;
}

// Returns every metric that some run has, in the order of the catalogue.
std::vector<ComparedMetric> SideBySide(const std::vector<RunToCompare>& runs) {
  std::vector<ComparedMetric> metrics;
  for (const std::string& name : AllMetricNames()) {
    ComparedMetric metric{name, "", {}, ""};
    const MetricValue* first = nullptr;
    for (const RunToCompare& run : runs) {
      const MetricValue* value = FindMetric(run.summary, name);
      metric.values.push_back(value == nullptr ? std::nullopt : std::optional(value->value));
      if (value == nullptr) continue;
      if (first == nullptr) first = value;
      metric.unit = NameOf(value->unit);
      if (metric.differing.empty()) {
        metric.differing = FirstDifference(first->contract, value->contract);
      }
    }
    if (first != nullptr) metrics.push_back(std::move(metric));
  }
  return metrics;
}

void JudgeAll(RunComparison& comparison) {
  std::vector<Difference*> differences;
  for (auto* list : {&comparison.by_frame, &comparison.by_body}) {
    for (PairedComparison& paired : *list) differences.push_back(&paired.difference);
  }
  CorrectForMany(differences);
  for (auto* list : {&comparison.by_frame, &comparison.by_body}) {
    for (PairedComparison& paired : *list) {
      paired.verdict =
          VerdictText(paired.difference, paired.metric, paired.frames > 0 ? "block" : "pair");
    }
  }
}

}  // namespace

RunComparison CompareRuns(const std::vector<fs::path>& folders) {
  Require(folders.size() >= 2, "CompareRuns: at least two runs");
  RunComparison comparison;
  std::vector<RunToCompare> runs;
  for (const fs::path& folder : folders) runs.push_back(ReadOne(folder, comparison.notes));
  CheckSameSequence(runs);
  std::vector<std::string> variants;
  for (const RunToCompare& run : runs) variants.push_back(run.summary.variant);
  const auto names = UniqueNames(variants, {folders.begin(), folders.end()});
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = names[i];
  comparison.sequence = runs.front().summary.sequence.name;
  comparison.runs = DescribeRuns(runs, folders);
  comparison.metrics = SideBySide(runs);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    for (PairedComparison& paired : PairByFrame(runs[i], runs.front())) {
      comparison.by_frame.push_back(std::move(paired));
    }
    for (PairedComparison& paired : PairByBody(runs[i], runs.front(), comparison.metrics)) {
      comparison.by_body.push_back(std::move(paired));
    }
  }
  JudgeAll(comparison);
  return comparison;
}

}  // namespace cvo::reports
