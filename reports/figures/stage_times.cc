// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

// In the order of the work; what is not named here follows, sums come last.
constexpr std::array kOrder = {
    "decode", "extract",   "load_features", "store_features", "match_stereo", "wait_for_features",
    "track",  "associate", "label",         "window",         "optimize",     "optimize_clusters"};
constexpr std::array kSums = {"estimate", "frame"};

template <std::size_t kSize>
int PlaceIn(const std::array<const char*, kSize>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

int Rank(const std::string& stage) {
  const int sum = PlaceIn(kSums, stage);
  if (sum >= 0) return 1000 + sum;
  const int place = PlaceIn(kOrder, stage);
  return place >= 0 ? place : 500;
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// Medians over the runs of a variant.
struct StageBar {
  double median_ms = 0.0;
  double p95_ms = 0.0;
};
struct VariantTimes {
  std::string variant;
  std::size_t runs = 0;
  std::map<std::string, StageBar> stages;
  double frames_per_second = 0.0;
};

std::string Machine(const RunDetail& detail) { return StrCat(detail.cpu, " (", detail.host, ")"); }

// Of the machine that most runs were on: times of two do not compare.
std::string MostUsedMachine(const std::vector<DrawnRun>& runs, std::vector<std::string>& machines) {
  std::map<std::string, std::size_t> counts;
  for (const DrawnRun& run : runs) {
    if (!run.detail.stages.empty()) ++counts[Machine(run.detail)];
  }
  std::string most;
  for (const auto& [machine, count] : counts) {
    machines.push_back(machine);
    if (most.empty() || count > counts[most]) most = machine;
  }
  return most;
}

std::vector<VariantTimes> Summarise(const std::vector<DrawnRun>& runs, const std::string& machine) {
  std::vector<VariantTimes> variants;
  std::map<std::string, std::map<std::string, std::pair<std::vector<double>, std::vector<double>>>>
      samples;
  std::map<std::string, std::vector<double>> speeds;
  for (const DrawnRun& run : runs) {
    if (run.detail.stages.empty() || Machine(run.detail) != machine) continue;
    if (speeds[run.variant].empty()) variants.push_back({run.variant, 0, {}, 0.0});
    speeds[run.variant].push_back(run.detail.frames_per_second);
    for (const StageTime& stage : run.detail.stages) {
      samples[run.variant][stage.stage].first.push_back(stage.median_ms);
      samples[run.variant][stage.stage].second.push_back(stage.p95_ms);
    }
  }
  for (VariantTimes& times : variants) {
    times.runs = speeds[times.variant].size();
    times.frames_per_second = Median(speeds[times.variant]);
    for (const auto& [stage, values] : samples[times.variant]) {
      times.stages[stage] = {Median(values.first), Median(values.second)};
    }
  }
  return variants;
}

// Stages that take some time somewhere.
std::vector<std::string> StagesOf(const std::vector<VariantTimes>& variants) {
  constexpr double kNothing_ms = 0.01;
  std::vector<std::string> stages;
  for (const VariantTimes& times : variants) {
    for (const auto& [stage, bar] : times.stages) {
      if (bar.p95_ms < kNothing_ms) continue;
      if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
    }
  }
  std::sort(stages.begin(), stages.end(), [](const std::string& a, const std::string& b) {
    return std::pair(Rank(a), a) < std::pair(Rank(b), b);
  });
  return stages;
}

std::string StageName(std::string stage) {
  std::replace(stage.begin(), stage.end(), '_', ' ');
  if (stage == "frame") return "whole frame";
  if (stage == "estimate") return "estimator, all";
  return stage;
}

Json Bars(const VariantTimes& times, const std::vector<std::string>& stages, const Style& style) {
  Json names = Json::array();
  Json medians = Json::array();
  Json above = Json::array();
  for (const std::string& stage : stages) {
    const auto found = times.stages.find(stage);
    if (found == times.stages.end()) continue;
    names.push_back(PlotText(StageName(stage)));
    medians.push_back(Rounded(found->second.median_ms, 3));
    above.push_back(Rounded(std::max(found->second.p95_ms - found->second.median_ms, 0.0), 3));
  }
  return {{"type", "bar"},
          {"orientation", "h"},
          {"name", PlotText(times.variant)},
          {"y", names},
          {"x", medians},
          {"error_x",
           {{"type", "data"},
            {"symmetric", false},
            {"array", above},
            {"arrayminus", Json::array()},
            {"thickness", 1},
            {"width", 2}}},
          {"marker", {{"color", style.colour}}},
          {"hovertemplate", "%{y}: %{x} ms"}};
}

std::string Alt(const std::vector<VariantTimes>& variants, const std::vector<std::string>& stages) {
  std::string text = StrCat("Bars of ", stages.size(), " stages, median milliseconds per frame. ");
  for (const VariantTimes& times : variants) {
    std::vector<std::pair<double, std::string>> largest;
    for (const auto& [stage, bar] : times.stages) {
      if (PlaceIn(kSums, stage) < 0) largest.emplace_back(-bar.median_ms, StageName(stage));
    }
    std::sort(largest.begin(), largest.end());
    text += StrCat(Capitalised(times.variant), ": ");
    const auto frame = times.stages.find("frame");
    if (frame != times.stages.end()) {
      text += StrCat(Say(frame->second.median_ms), " ms for a whole frame, ");
    }
    for (std::size_t i = 0; i < largest.size() && i < 3; ++i) {
      text +=
          StrCat(i > 0 ? ", " : "most in ", largest[i].second, " ", Say(-largest[i].first), " ms");
    }
    text += StrCat("; ", Say(times.frames_per_second), " frames per second. ");
  }
  text.pop_back();
  return text;
}

}  // namespace

void DrawStageTimes(const SuiteData& data, SuiteDrawing& drawing) {
  std::vector<std::string> machines;
  const std::string machine = MostUsedMachine(data.drawn, machines);
  const std::vector<VariantTimes> variants = Summarise(data.drawn, machine);
  const std::vector<std::string> stages = StagesOf(variants);
  if (stages.empty()) {
    drawing.not_drawn.emplace_back("Time by stage: no run with a timing.json that can be read.");
    return;
  }
  std::vector<std::string> names;
  for (const VariantTimes& times : variants) names.push_back(times.variant);
  const Palette palette = PaletteOf(data.plan, names);
  Panel panel{AxisOf(""), 0};
  panel.height_px = static_cast<int>(stages.size()) * (14 + 9 * static_cast<int>(variants.size()));
  panel.y_axis.update({{"autorange", "reversed"},
                       {"type", "category"},
                       {"ticks", ""},
                       {"categoryarray", Json::array()}});
  for (const std::string& stage : stages) {
    panel.y_axis["categoryarray"].push_back(PlotText(StageName(stage)));
  }
  Json x_axis = AxisOf("time per frame (ms)");
  x_axis["rangemode"] = "tozero";
  Plot plot(x_axis, {panel});
  for (const VariantTimes& times : variants) {
    plot.AddTrace(0, Bars(times, stages, palette.Of(times.variant)));
  }
  plot.layout().update({{"barmode", "group"}, {"bargap", 0.25}, {"bargroupgap", 0.0}});
  Figure figure;
  figure.id = "stage-times";
  figure.group = "Time";
  figure.title = "Time per frame by stage";
  figure.caption = StrCat(
      "Bars: median over the frames of a run; whiskers: to its 95th percentile; both the median "
      "over ",
      Listed([&] {
        std::vector<std::string> runs;
        for (const VariantTimes& times : variants) {
          runs.push_back(
              StrCat(times.runs, times.runs == 1 ? " run of " : " runs of ", times.variant));
        }
        return runs;
      }()),
      ". Measured on ", machine,
      ". Times depend on the machine and on what else it does: they "
      "are no part of the accuracy.");
  if (machines.size() > 1) {
    figure.caption += StrCat(" Runs on ", machines.size() - 1, " other machines are left out.");
  }
  figure.alt = Alt(variants, stages);
  figure.width_px = 620;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
