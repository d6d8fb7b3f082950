// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/error.h"
#include "core/base/mean.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"

namespace cvo::reports {
namespace {

constexpr int kPlotWidth_px = 980;
constexpr int kMap_px = 400;       // height of the map
constexpr int kErrors_px = 160;    // height of the error panels below it
constexpr int kBetween_px = 64;    // for the x axis of the upper panels
constexpr int kInner_px = 10;      // gap between the coordinate panels
constexpr double kLeftEnd = 0.47;  // right edge of the map and of the left error panel
constexpr double kRightBegin = 0.57;
constexpr std::size_t kMaxLinePoints = 2000;  // per line
constexpr double kGap = 5.5;  // intervals longer than this many median intervals break a line

constexpr std::array kAxisNames = {"x", "y", "z"};

struct TrackLine {
  std::string colour;
  double width = 1.8;
  const char* dash = "solid";
};

double UsualInterval(const std::vector<double>& time) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time.size(); ++i) intervals.push_back(time[i] - time[i - 1]);
  if (intervals.empty()) return 0.0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

// The line through (x(i), y(i)), broken at gaps in time. Very long lines are reduced to every k-th
// point.
template <typename X, typename Y>
Json LineThrough(const std::vector<double>& time, const X& x, const Y& y) {
  const double longest = kGap * UsualInterval(time);
  const std::size_t step =
      std::max<std::size_t>(1, (time.size() + kMaxLinePoints - 1) / kMaxLinePoints);
  Json trace = {{"type", "scatter"}, {"mode", "lines"}, {"x", Json::array()}, {"y", Json::array()}};
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool after_gap = i > 0 && time[i] - time[i - 1] > longest;
    const bool before_gap = i + 1 == time.size() || time[i + 1] - time[i] > longest;
    if (after_gap) {
      trace["x"].push_back(nullptr);
      trace["y"].push_back(nullptr);
    }
    if (i % step != 0 && !after_gap && !before_gap) continue;
    trace["x"].push_back(Rounded(x(i), 7));
    trace["y"].push_back(Rounded(y(i), 7));
  }
  return trace;
}

// The extent of everything on the map, widened. The shorter side is at least kLeastPart of the
// longer one.
struct MapExtent {
  double low[2] = {std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  double high[2] = {-low[0], -low[1]};

  void Add(const std::vector<Position>& positions_m, std::size_t ahead) {
    for (const Position& position : positions_m) {
      for (const std::size_t k : {0U, 1U}) {
        low[k] = std::min(low[k], position[k == 0 ? 0 : ahead]);
        high[k] = std::max(high[k], position[k == 0 ? 0 : ahead]);
      }
    }
  }
  Json Range(std::size_t k) const {
    constexpr double kLeastPart = 0.35;
    constexpr double kMargin = 1.12;
    const double other = high[1 - k] - low[1 - k];
    const double side = std::max({high[k] - low[k], kLeastPart * other, 1e-3});
    const double middle = 0.5 * (low[k] + high[k]);
    return {Rounded(middle - 0.5 * kMargin * side, 7), Rounded(middle + 0.5 * kMargin * side, 7)};
  }
};

MapExtent ExtentOf(const TrajectoryPlot& plot, std::size_t ahead) {
  MapExtent extent;
  for (const PlottedTrack& track : plot.truth) extent.Add(track.position_m, ahead);
  for (const PlottedTrack& track : plot.tracks) extent.Add(track.position_m, ahead);
  for (const PlottedBody& body : plot.bodies) {
    extent.Add(body.truth_m, ahead);
    extent.Add(body.position_m, ahead);
  }
  return extent;
}

// The axes, from left to right and from top to bottom, with the data that are drawn in them.
class TrajectoryPanels {
 public:
  TrajectoryPanels(const TrajectoryPlot& plot, bool errors, int legend_px)
      : plot_(plot), inner_px_(kMap_px + (errors ? kBetween_px + kErrors_px : 0)) {
    layout_ = BaseLayout(inner_px_ + legend_px + 58, legend_px, 58);
    const double map_low = Height(inner_px_ - kMap_px);
    AddMap(map_low);
    AddAxis("xaxis2", AxisOf(plot.time_title), kRightBegin, 1.0, "y4");
    const int panel_px = (kMap_px - 2 * kInner_px) / 3;
    for (int i = 0; i < 3; ++i) {
      const int top_px = inner_px_ - i * (panel_px + kInner_px);
      Json axis = AxisOf(StrCat(kAxisNames[static_cast<std::size_t>(i)], " (m)"));
      axis["nticks"] = 5;
      AddAxis(StrCat("yaxis", i + 2), std::move(axis), Height(top_px - panel_px), Height(top_px),
              "x2");
    }
    if (!errors) return;
    AddErrors("5", "3", 0.0, kLeftEnd, plot.error_title + " (m)");
    AddErrors("6", "4", kRightBegin, 1.0, plot.rotation_title + " (deg)");
  }

  void AddToMap(const std::vector<double>& time, const std::vector<Position>& positions_m,
                const std::string& name, const TrackLine& style) {
    const std::size_t ahead = AheadAxis();
    Json trace = LineThrough(
        time, [&](std::size_t i) { return positions_m[i][0]; },
        [&](std::size_t i) { return positions_m[i][ahead]; });
    Add(std::move(trace), name, style, "x", "y",
        StrCat(": x %{x} m, ", kAxisNames[ahead], " %{y} m"));
  }
  void AddCoordinates(const PlottedTrack& track, const TrackLine& style) {
    for (std::size_t k = 0; k < 3; ++k) {
      Json trace = LineThrough(
          track.time, [&](std::size_t i) { return track.time[i]; },
          [&](std::size_t i) { return track.position_m[i][k]; });
      Add(std::move(trace), track.name, style, "x2", StrCat("y", k + 2),
          StrCat(": ", kAxisNames[k], " %{y} m at %{x}"));
    }
  }
  void AddErrorsOf(const PlottedTrack& track, const TrackLine& style) {
    const auto add = [&](const TimedValues& values, const char* x, const char* y,
                         const char* unit) {
      Json trace = LineThrough(
          values.time, [&](std::size_t i) { return values.time[i]; },
          [&](std::size_t i) { return values.values[i]; });
      Add(std::move(trace), track.name, style, x, y, StrCat(": %{y} ", unit, " at %{x}"));
    };
    add(track.position_error_m, "x3", "y5", "m");
    add(track.rotation_error_deg, "x4", "y6", "deg");
  }
  void AddLegend(const std::string& name, const TrackLine& style) {
    data_.push_back({{"type", "scatter"},
                     {"mode", "lines"},
                     {"x", {nullptr}},
                     {"y", {nullptr}},
                     {"name", PlotText(name)},
                     {"hoverinfo", "skip"},
                     {"line", LineJson(style)}});
  }
  // Marks the first position by a disc, with the name beside it unless it is empty.
  void AddStart(const std::vector<Position>& positions_m, const std::string& name,
                const TrackLine& style) {
    if (positions_m.empty()) return;
    const Position& at = positions_m.front();
    data_.push_back({{"type", "scatter"},
                     {"mode", name.empty() ? "markers" : "markers+text"},
                     {"x", {Rounded(at[0], 7)}},
                     {"y", {Rounded(at[AheadAxis()], 7)}},
                     {"text", {PlotText(name)}},
                     {"textposition", "top right"},
                     {"textfont", {{"size", 10}}},
                     {"showlegend", false},
                     {"hovertemplate", "start<extra></extra>"},
                     {"marker", {{"size", 7}, {"color", style.colour}}}});
  }
  int height_px() const { return layout_["height"].get<int>(); }
  std::string Text() const { return PlotJson(data_, layout_); }

 private:
  std::size_t AheadAxis() const { return plot_.vertical == Vertical::kYDown ? 2 : 1; }
  double Height(int px) const { return Rounded(static_cast<double>(px) / inner_px_, 6); }

  static Json LineJson(const TrackLine& style) {
    return {{"color", style.colour}, {"width", style.width}, {"dash", style.dash}};
  }
  void Add(Json trace, const std::string& name, const TrackLine& style, const std::string& x,
           const std::string& y, const std::string& hover) {
    trace.update({{"xaxis", x},
                  {"yaxis", y},
                  {"showlegend", false},
                  {"line", LineJson(style)},
                  {"hovertemplate", StrCat(PlotText(name), hover, "<extra></extra>")}});
    data_.push_back(std::move(trace));
  }
  void AddAxis(const std::string& name, Json axis, double low, double high,
               const std::string& anchor) {
    axis["domain"] = {low, high};
    axis["anchor"] = anchor;
    layout_[name] = std::move(axis);
  }
  void AddMap(double low) {
    const MapExtent extent = ExtentOf(plot_, AheadAxis());
    Json x = AxisOf("x (m)");
    x["constrain"] = "domain";
    x["range"] = extent.Range(0);
    Json y = AxisOf(plot_.vertical == Vertical::kYDown ? "z, ahead (m)" : "y (m)");
    y["constrain"] = "domain";
    y["range"] = extent.Range(1);
    y["scaleanchor"] = "x";
    AddAxis("xaxis", std::move(x), 0.0, kLeftEnd, "y");
    AddAxis("yaxis", std::move(y), low, 1.0, "x");
  }
  void AddErrors(const std::string& y, const std::string& x, double left, double right,
                 const std::string& title) {
    AddAxis("xaxis" + x, AxisOf(plot_.time_title), left, right, "y" + y);
    Json axis = AxisOf(title);
    axis["rangemode"] = "tozero";
    axis["nticks"] = 5;
    AddAxis("yaxis" + y, std::move(axis), 0.0, Height(kErrors_px), "x" + x);
  }

  const TrajectoryPlot& plot_;
  int inner_px_;
  Json data_ = Json::array();
  Json layout_;
};

// Such as "full: 200 poses, position error 0.043 m root mean square, at most 0.1 m".
std::string TrackText(const PlottedTrack& track) {
  std::string text = StrCat(track.name, ": ", track.time.size(), " poses");
  const std::vector<double>& errors = track.position_error_m.values;
  if (errors.empty()) return text;
  return StrCat(text, ", position error ", NumberText(RootMeanSquare(errors).value()),
                " m root mean square, at most ",
                NumberText(*std::max_element(errors.begin(), errors.end())), " m");
}

void DrawBodyOf(const PlottedBody& body, const std::string& colour, TrajectoryPanels& panels) {
  const TrackLine truth{kTruthColour, 3.0};
  panels.AddToMap(body.truth_time, body.truth_m, body.name + ", truth", truth);
  panels.AddStart(body.truth_m, body.name, truth);
  panels.AddToMap(body.time, body.position_m, body.name, {colour, 1.3});
  if (body.truth_m.empty()) panels.AddStart(body.position_m, body.name, {colour});
}

}  // namespace

Figure DrawTrajectoryPlot(const TrajectoryPlot& plot) {
  std::vector<std::string> names;
  for (const PlottedTrack& track : plot.tracks) names.push_back(track.name);
  const Palette palette(names);
  const bool errors = std::any_of(plot.tracks.begin(), plot.tracks.end(), [](const auto& track) {
    return !track.position_error_m.time.empty();
  });
  std::vector<std::string> entries;
  for (const PlottedTrack& track : plot.tracks) entries.push_back(track.legend);
  for (const PlottedTrack& truth : plot.truth) entries.push_back(truth.legend);
  TrajectoryPanels panels(plot, errors, LegendHeight(entries, kPlotWidth_px));
  Figure figure;
  figure.alt = "Map from above, coordinates over time";
  figure.alt += errors ? " and errors over time. " : ". ";
  for (const PlottedTrack& truth : plot.truth) {
    const TrackLine style{kTruthColour, 4.0};
    panels.AddLegend(truth.legend, style);
    panels.AddToMap(truth.time, truth.position_m, truth.name, style);
    panels.AddCoordinates(truth, style);
    panels.AddStart(truth.position_m, "", style);
  }
  for (const PlottedTrack& track : plot.tracks) {
    const Style& look = palette.Of(track.name);
    const TrackLine style{look.colour, 1.8, look.dash.c_str()};
    panels.AddLegend(track.legend, style);
    panels.AddToMap(track.time, track.position_m, track.name, style);
    panels.AddCoordinates(track, style);
    if (errors) panels.AddErrorsOf(track, style);
    if (plot.truth.empty()) panels.AddStart(track.position_m, "", style);
    figure.alt += TrackText(track) + ". ";
  }
  for (const PlottedBody& body : plot.bodies) {
    DrawBodyOf(body, palette.Of(names.front()).colour, panels);
  }
  figure.alt.pop_back();
  figure.id = "trajectories";
  figure.title = plot.title;
  figure.caption = plot.caption;
  figure.group = "Trajectories";
  figure.width_px = kPlotWidth_px;
  figure.height_px = panels.height_px();
  figure.plotly = panels.Text();
  return figure;
}

}  // namespace cvo::reports
