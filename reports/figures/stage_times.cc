// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/figure_style.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

// The front end is the same for all variants of a sequence, and its result is cached: only the
// first run computes it.
const std::vector<std::string> kFrontEnd = {"decode", "extract", "match_stereo"};
// Stages whose time depends on whether features were cached.
const std::vector<std::string> kCacheStages = {"load_features", "store_features",
                                               "wait_for_features", "frame"};
// In the order of processing. Stages that are not named here follow; the sum comes last.
const std::vector<std::string> kEstimator = {
    "track", "associate", "label", "window", "optimize", "trace", "optimize_clusters"};
constexpr char kSum[] = "estimate";
constexpr char kAllVariants[] = "front end, all variants";

bool IsIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The times of the stages of a variant, or of the front end: one value per run.
struct StageSamples {
  std::vector<double> median_ms;
  std::vector<double> p95_ms;
};
struct StageSeries {
  std::string name;
  std::size_t runs = 0;
  bool slowed = false;  // all its runs computed features at the same time
  std::map<std::string, StageSamples> stages = {};
};

std::string MachineOf(const RunDetail& detail) {
  return StrCat(detail.timing.cpu, " (", detail.timing.host, ")");
}

// The runs on the machine on which most were made: times on different machines are not comparable.
std::vector<const DrawnRun*> TimedRuns(const std::vector<DrawnRun>& runs) {
  std::map<std::string, std::vector<const DrawnRun*>> by_machine;
  for (const DrawnRun& run : runs) {
    if (!run.detail.timing.stages.empty()) by_machine[MachineOf(run.detail)].push_back(&run);
  }
  const auto most = std::max_element(
      by_machine.begin(), by_machine.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  return most == by_machine.end() ? std::vector<const DrawnRun*>() : most->second;
}

bool HasFrontEnd(const DrawnRun& run) {
  return std::any_of(run.detail.timing.stages.begin(), run.detail.timing.stages.end(),
                     [](const auto& stage) { return IsIn(kFrontEnd, stage.first); });
}

void AddRun(const DrawnRun& run, bool front_end, StageSeries& series) {
  ++series.runs;
  for (const auto& [stage, time] : run.detail.timing.stages) {
    if (IsIn(kCacheStages, stage) || IsIn(kFrontEnd, stage) != front_end) continue;
    series.stages[stage].median_ms.push_back(time.median_ms);
    series.stages[stage].p95_ms.push_back(time.p95_ms);
  }
}

// Gathers the times by series: the front end first, then the variants in the order of the runs. A
// run that computes features at the same time is slower, so such runs of a variant count only if it
// has no others.
std::vector<StageSeries> Gather(const std::vector<const DrawnRun*>& timed) {
  std::vector<StageSeries> series = {{kAllVariants}};
  for (const DrawnRun* run : timed) {
    const bool has_others = std::any_of(timed.begin(), timed.end(), [&](const DrawnRun* other) {
      return other->variant == run->variant && !HasFrontEnd(*other);
    });
    if (HasFrontEnd(*run)) AddRun(*run, true, series[0]);
    StageSeries& own = FindOrAdd(series, &StageSeries::name, {run->variant});
    own.slowed = !has_others;
    if (!has_others || !HasFrontEnd(*run)) AddRun(*run, false, own);
  }
  return series;
}

// The stages of the estimator that take a noticeable time in at least one series.
std::vector<std::string> EstimatorStages(const std::vector<StageSeries>& series) {
  constexpr double kNothing_ms = 0.01;
  std::vector<std::string> found;
  for (std::size_t i = 1; i < series.size(); ++i) {
    for (const auto& [stage, samples] : series[i].stages) {
      if (Median(samples.p95_ms) >= kNothing_ms) AddOnce(stage, found);
    }
  }
  std::vector<std::string> stages;
  for (const std::string& stage : kEstimator) {
    if (IsIn(found, stage)) stages.push_back(stage);
  }
  std::sort(found.begin(), found.end());
  for (const std::string& stage : found) {
    if (stage != kSum) AddOnce(stage, stages);
  }
  if (IsIn(found, kSum)) stages.emplace_back(kSum);
  return stages;
}

std::string StageName(std::string stage) {
  std::replace(stage.begin(), stage.end(), '_', ' ');
  return stage == kSum ? "estimator, sum" : stage;
}

// The bars of a series, as the `place`-th of `places` in each row.
Series BarsOf(const StageSeries& series, const std::vector<std::string>& stages, Look look,
              std::size_t place, std::size_t places) {
  constexpr double kFilled = 0.8;  // of a row
  if (series.slowed) look.opacity = 0.35;
  Series bars{SeriesKind::kBars, series.name, look, {}};
  bars.bar_width = kFilled / static_cast<double>(places);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto found = series.stages.find(stages[i]);
    if (found == series.stages.end()) continue;
    Datum bar;
    bar.x = Median(found->second.median_ms);
    bar.y = static_cast<double>(i) - 0.5 * kFilled +
            (static_cast<double>(place) + 0.5) * bars.bar_width;
    bar.x_interval = {bar.x, std::max(bar.x, Median(found->second.p95_ms))};
    bar.tip = StrCat(series.name, ", ", StageName(stages[i]), ": ", NumberText(bar.x),
                     " ms, 95 %: ", NumberText(bar.x_interval->high), " ms");
    bars.data.push_back(std::move(bar));
  }
  return bars;
}

Panel PanelOf(const std::vector<std::string>& stages, std::size_t bars) {
  Panel panel;
  panel.x.title = "time per frame (ms)";
  panel.x.from_zero = true;
  panel.y.scale = AxisScale::kCategory;
  for (const std::string& stage : stages) panel.y.categories.push_back(StageName(stage));
  panel.row_height = 0.9 + 0.8 * static_cast<double>(bars);
  return panel;
}

}  // namespace

void AddStageTimes(const SuiteData& data, SuiteFigures& figures) {
  const std::vector<const DrawnRun*> timed = TimedRuns(data.drawn);
  const std::vector<StageSeries> series = Gather(timed);
  const std::vector<std::string> stages = EstimatorStages(series);
  if (stages.empty()) {
    figures.not_drawn.emplace_back("Time by stage: no run with a timing.json that can be read.");
    return;
  }
  const Palette palette = PaletteOfDrawn(data);
  Chart chart;
  chart.share_x = true;
  chart.width = 0.8;
  if (series[0].runs > 0) {
    chart.panels.push_back(PanelOf(kFrontEnd, 1));
    chart.panels[0].series = {BarsOf(series[0], kFrontEnd, {0}, 0, 1)};
  }
  const std::size_t bars = series.size() - 1;
  chart.panels.push_back(PanelOf(stages, bars));
  for (std::size_t i = 0; i < bars; ++i) {
    const StageSeries& one = series[i + 1];
    chart.panels.back().series.push_back(BarsOf(one, stages, palette.Line(one.name), i, bars));
  }
  std::string caption =
      StrCat("Measured on ", MachineOf(timed.front()->detail),
             ". Bars: median over the frames of a run; whiskers: to its 95th percentile; both the "
             "median over runs.");
  if (FindBy(series, &StageSeries::slowed, true) != nullptr) {
    caption += " Pale: runs that computed features at the same time, which slows them.";
  }
  if (timed.size() < data.drawn.size()) {
    caption += StrCat(" ", Counted(data.drawn.size() - timed.size(), "run"),
                      " of other machines or without times left out.");
  }
  figures.figures.push_back({"stage-times", "Time per frame by stage", caption, std::move(chart)});
}

}  // namespace cvo::reports
