// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/base/median.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite/suite_parts.h"

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
constexpr int kBarsWidth_px = 620;
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

Json Bars(const StageSeries& series, const std::vector<std::string>& stages,
          const std::string& colour) {
  Json names = Json::array();
  Json medians = Json::array();
  Json above = Json::array();
  for (const std::string& stage : stages) {
    const auto found = series.stages.find(stage);
    if (found == series.stages.end()) continue;
    const double median_ms = Median(found->second.median_ms);
    names.push_back(PlotText(StageName(stage)));
    medians.push_back(Rounded(median_ms, 3));
    above.push_back(Rounded(std::max(Median(found->second.p95_ms) - median_ms, 0.0), 3));
  }
  return {{"type", "bar"},
          {"orientation", "h"},
          {"name", PlotText(series.name)},
          {"y", names},
          {"x", medians},
          {"error_x",
           {{"type", "data"},
            {"symmetric", false},
            {"array", above},
            {"arrayminus", Json::array()},
            {"color", kTruthColour},
            {"thickness", 1},
            {"width", 2}}},
          {"marker",
           {{"color", series.beside_front_end ? Faded(colour, 0.35) : colour},
            {"line", {{"color", colour}, {"width", 1}}}}},
          {"hovertemplate", "%{y}: %{x} ms"}};
}

Panel PanelOf(const std::vector<std::string>& stages, int bars) {
  Panel panel{AxisOf(""), static_cast<int>(stages.size()) * (12 + 9 * bars)};
  panel.y_axis.update({{"autorange", "reversed"}, {"type", "category"}, {"ticks", ""}});
  panel.y_axis["categoryorder"] = "array";
  panel.y_axis["categoryarray"] = Json::array();
  for (const std::string& stage : stages) {
    panel.y_axis["categoryarray"].push_back(PlotText(StageName(stage)));
  }
  return panel;
}

// Describes a series: the sum if there is one, and the stages that take most time.
std::string StageSeriesText(const StageSeries& series) {
  std::vector<std::pair<double, std::string>> largest;
  for (const auto& [stage, samples] : series.stages) {
    if (stage != kSum) largest.emplace_back(-Median(samples.median_ms), StageName(stage));
  }
  std::sort(largest.begin(), largest.end());
  std::string text = Capitalised(series.name) + ": ";
  const auto sum = series.stages.find(kSum);
  if (sum != series.stages.end()) {
    text +=
        StrCat(NumberText(Median(sum->second.median_ms)), " ms for all of the estimator, most in ");
  }
  for (std::size_t i = 0; i < largest.size() && i < 3; ++i) {
    text += StrCat(i > 0 ? ", " : "", largest[i].second, " ", NumberText(-largest[i].first), " ms");
  }
  return text + ". ";
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

Plot MakePlot(const SuiteData& data, const std::vector<StageSeries>& series,
              const std::vector<std::string>& stages) {
  std::vector<std::string> names;
  for (const StageSeries& one : series) names.push_back(one.name);
  const Palette palette = PaletteOf(data.plan, names);
  const std::vector<std::string> front_end(kFrontEnd.begin(), kFrontEnd.end());
  const bool has_front_end = series[0].runs > 0;
  std::vector<Panel> panels;
  if (has_front_end) panels.push_back(PanelOf(front_end, 1));
  panels.push_back(PanelOf(stages, static_cast<int>(series.size()) - 1));
  Json x_axis = AxisOf("time per frame (ms)");
  x_axis["rangemode"] = "tozero";
  Plot plot(x_axis, panels, LegendHeight(names, kBarsWidth_px));
  for (const StageSeries& one : series) {
    if (one.name != kAllVariants) {
      plot.AddTrace(panels.size() - 1, Bars(one, stages, palette.Of(one.name).colour));
    } else if (has_front_end) {
      plot.AddTrace(0, Bars(one, front_end, kTruthColour));
    }
  }
  plot.layout().update({{"barmode", "group"}, {"bargap", 0.25}, {"bargroupgap", 0.0}});
  return plot;
}

}  // namespace

void DrawStageTimes(const SuiteData& data, SuiteDrawing& drawing) {
  std::size_t machines = 0;
  const std::string machine = MostUsedMachine(data.drawn, machines);
  const std::vector<StageSeries> series = Gather(data.drawn, machine);
  const std::vector<std::string> stages = EstimatorStages(series);
  if (stages.empty()) {
    drawing.not_drawn.emplace_back("Time by stage: no run with a timing.json that can be read.");
    return;
  }
  const Plot plot = MakePlot(data, series, stages);
  Figure figure;
  figure.id = "stage-times";
  figure.group = "Time";
  figure.title = "Time per frame by stage";
  figure.caption = Caption(series, machine, machines);
  figure.alt = StrCat("Bars of ", stages.size(), " stages, median milliseconds per frame, on ",
                      machine, ". ");
  for (const StageSeries& one : series) {
    if (one.runs > 0) figure.alt += StageSeriesText(one);
  }
  figure.alt.pop_back();
  figure.width_px = kBarsWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
