// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

// The front end is the same for all variants of a sequence, and its result is cached: only the
// first run computes it.
constexpr std::array kFrontEnd = {"decode", "extract", "match_stereo"};
// Stages whose time depends on whether features were cached.
constexpr std::array kCacheStages = {"load_features", "store_features", "wait_for_features",
                                     "frame"};
// In the order of processing. Stages that are not named here follow; the sum comes last.
constexpr std::array kEstimator = {"track", "associate",         "label",   "window", "optimize",
                                   "trace", "optimize_clusters", "estimate"};
constexpr char kSum[] = "estimate";
constexpr char kAllVariants[] = "front end, all variants";

template <std::size_t kSize>
int PlaceIn(const std::array<const char*, kSize>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

int Rank(const std::string& stage) {
  if (stage == kSum) return 1000;
  const int place = PlaceIn(kEstimator, stage);
  return place >= 0 ? place : 500;
}

// The times of a stage, one value per run.
struct StageSamples {
  std::vector<double> median_ms;
  std::vector<double> p95_ms;
};
struct StageSeries {
  std::string name;  // variant, or kAllVariants for the front end
  std::size_t runs = 0;
  bool beside_front_end = false;  // all its runs computed features at the same time
  std::map<std::string, StageSamples> stages;
};

std::string MachineOf(const RunDetail& detail) {
  return StrCat(detail.cpu, " (", detail.host, ")");
}

// The machine on which most runs were made. Times on different machines are not comparable.
std::string MostUsedMachine(const std::vector<DrawnRun>& runs, std::size_t& machines) {
  std::map<std::string, std::size_t> counts;
  for (const DrawnRun& run : runs) {
    if (!run.detail.stages.empty()) ++counts[MachineOf(run.detail)];
  }
  machines = counts.size();
  std::string most;
  for (const auto& [machine, count] : counts) {
    if (most.empty() || count > counts[most]) most = machine;
  }
  return most;
}

StageSeries& SeriesOf(const std::string& name, std::vector<StageSeries>& series) {
  return FindOrAdd(series, &StageSeries::name, {name, 0, false, {}});
}

bool HasFrontEnd(const DrawnRun& run) {
  return std::any_of(run.detail.stages.begin(), run.detail.stages.end(),
                     [](const StageTime& stage) { return PlaceIn(kFrontEnd, stage.stage) >= 0; });
}

void AddRun(const DrawnRun& run, bool front_end, StageSeries& series) {
  ++series.runs;
  for (const StageTime& stage : run.detail.stages) {
    if (PlaceIn(kCacheStages, stage.stage) >= 0) continue;
    if ((PlaceIn(kFrontEnd, stage.stage) >= 0) != front_end) continue;
    series.stages[stage.stage].median_ms.push_back(stage.median_ms);
    series.stages[stage.stage].p95_ms.push_back(stage.p95_ms);
  }
}

// Gathers the times by series: the front end first, then the variants in the order of the runs. A
// run that computes features at the same time is slower, so such runs of a variant count only if it
// has no others.
std::vector<StageSeries> Gather(const std::vector<DrawnRun>& runs, const std::string& machine) {
  std::vector<StageSeries> series = {{kAllVariants, 0, false, {}}};
  std::vector<const DrawnRun*> timed;
  for (const DrawnRun& run : runs) {
    if (!run.detail.stages.empty() && MachineOf(run.detail) == machine) timed.push_back(&run);
  }
  for (const DrawnRun* run : timed) {
    const bool alone = std::any_of(timed.begin(), timed.end(), [&](const DrawnRun* other) {
      return other->variant == run->variant && !HasFrontEnd(*other);
    });
    if (HasFrontEnd(*run)) AddRun(*run, true, series[0]);
    StageSeries& own = SeriesOf(run->variant, series);
    own.beside_front_end = !alone;
    if (!alone || !HasFrontEnd(*run)) AddRun(*run, false, own);
  }
  return series;
}

// The stages of the estimator that take a noticeable time in at least one series.
std::vector<std::string> EstimatorStages(const std::vector<StageSeries>& series) {
  constexpr double kNothing_ms = 0.01;
  std::vector<std::string> stages;
  for (const StageSeries& one : series) {
    if (one.name == kAllVariants) continue;
    for (const auto& [stage, samples] : one.stages) {
      if (Median(samples.p95_ms) < kNothing_ms) continue;
      AddOnce(stage, stages);
    }
  }
  std::sort(stages.begin(), stages.end(), [](const std::string& a, const std::string& b) {
    return std::pair(Rank(a), a) < std::pair(Rank(b), b);
  });
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
  if (series.beside_front_end) look.opacity = 0.35;
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

std::string Caption(const std::vector<StageSeries>& series, const std::string& machine,
                    std::size_t machines) {
  std::vector<std::string> runs;
  std::vector<std::string> beside;
  for (const StageSeries& one : series) {
    if (one.runs > 0) runs.push_back(StrCat(one.name, " (", one.runs, ")"));
    if (one.beside_front_end) beside.push_back(one.name);
  }
  std::string text = StrCat(
      "Measured on ", machine,
      ". Bars: median over the frames of a run; whiskers: to its 95th percentile; both the median "
      "over runs of ",
      Listed(runs),
      ". Times depend on the machine and its load and say nothing about accuracy. Stages that "
      "depend on whether features were cached are left out.");
  if (!beside.empty() && beside.size() + 1 < series.size()) {
    text += StrCat(" Pale: all runs of ", Listed(beside),
                   " computed features at the same time, which slows them; do not compare them "
                   "with the others.");
  }
  if (machines > 1) text += StrCat(" Runs on ", machines - 1, " other machines are left out.");
  return text;
}

Chart ChartOf(const SuiteData& data, const std::vector<StageSeries>& series,
              const std::vector<std::string>& stages) {
  std::vector<std::string> names;
  for (const StageSeries& one : series) names.push_back(one.name);
  const Palette palette = PaletteOf(data.plan, names);
  const std::vector<std::string> front_end(kFrontEnd.begin(), kFrontEnd.end());
  Chart chart;
  chart.share_x = true;
  chart.width = 0.8;
  if (series[0].runs > 0) {
    chart.panels.push_back(PanelOf(front_end, 1));
    chart.panels[0].series = {BarsOf(series[0], front_end, {0}, 0, 1)};
  }
  const std::size_t bars = series.size() - 1;
  chart.panels.push_back(PanelOf(stages, bars));
  for (std::size_t i = 0; i < bars; ++i) {
    const StageSeries& one = series[i + 1];
    chart.panels.back().series.push_back(BarsOf(one, stages, palette.Line(one.name), i, bars));
  }
  return chart;
}

}  // namespace

void AddStageTimes(const SuiteData& data, SuiteFigures& figures) {
  std::size_t machines = 0;
  const std::string machine = MostUsedMachine(data.drawn, machines);
  const std::vector<StageSeries> series = Gather(data.drawn, machine);
  const std::vector<std::string> stages = EstimatorStages(series);
  if (stages.empty()) {
    figures.not_drawn.emplace_back("Time by stage: no run with a timing.json that can be read.");
    return;
  }
  figures.figures.push_back({"stage-times", "Time per frame by stage",
                             Caption(series, machine, machines), ChartOf(data, series, stages)});
}

}  // namespace cvo::reports
