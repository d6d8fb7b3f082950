// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite/drawn_scenes.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxPanels = 9;
constexpr std::size_t kMaxPoints = 150;  // per line

// A point seen from above: x is to the right of the first camera, z ahead of it.
struct GroundPoint {
  int frame = 0;
  double x_m = 0.0;
  double z_m = 0.0;
};
using Track = std::vector<GroundPoint>;

struct Extent {
  double x_low = std::numeric_limits<double>::infinity();
  double x_high = -std::numeric_limits<double>::infinity();
  double z_low = std::numeric_limits<double>::infinity();
  double z_high = -std::numeric_limits<double>::infinity();

  void Add(const Track& track) {
    for (const GroundPoint& point : track) {
      x_low = std::min(x_low, point.x_m);
      x_high = std::max(x_high, point.x_m);
      z_low = std::min(z_low, point.z_m);
      z_high = std::max(z_high, point.z_m);
    }
  }
  bool IsEmpty() const { return x_high < x_low; }
  void Widen() {
    const double margin = 0.06 * std::max({x_high - x_low, z_high - z_low, 0.1});
    x_low -= margin;
    x_high += margin;
    z_low -= margin;
    z_high += margin;
  }
  bool Holds(const Track& track) const {
    return std::all_of(track.begin(), track.end(), [&](const GroundPoint& point) {
      return point.x_m >= x_low && point.x_m <= x_high && point.z_m >= z_low && point.z_m <= z_high;
    });
  }
};

Track CameraTrack(const RunDetail& detail, bool truth) {
  Track track;
  for (const CameraFrame& frame : detail.camera) {
    if (truth && frame.truth) track.push_back({frame.frame, (*frame.truth)[0], (*frame.truth)[2]});
    if (!truth && frame.status != "skipped") {
      track.push_back({frame.frame, frame.world_from_camera[0], frame.world_from_camera[2]});
    }
  }
  return track;
}

// The true track from the first frame in which the body is visible to the last.
Track TruthTrack(const BodyDetail& body) {
  Track track;
  if (body.visible.empty()) return track;
  for (const auto& [frame, pose] : body.truth) {
    if (frame < body.visible.front() || frame > body.visible.back()) continue;
    track.push_back({frame, pose[0], pose[2]});
  }
  return track;
}

Track EstimatedTrack(const BodyDetail& body) {
  Track track;
  for (const BodyPosition& position : body.estimated) {
    track.push_back({position.frame, position.position_m[0], position.position_m[2]});
  }
  return track;
}

// A line with a limited number of points, which keeps its ends and gaps.
Json LineOf(const Track& track) {
  const std::size_t step = std::max<std::size_t>(1, (track.size() + kMaxPoints - 1) / kMaxPoints);
  Json x = Json::array();
  Json y = Json::array();
  for (std::size_t i = 0; i < track.size(); ++i) {
    const bool after_gap = i > 0 && track[i].frame > track[i - 1].frame + 1;
    const bool before_gap = i + 1 == track.size() || track[i + 1].frame > track[i].frame + 1;
    if (after_gap) {
      x.push_back(nullptr);
      y.push_back(nullptr);
    }
    if (i % step != 0 && !after_gap && !before_gap) continue;
    x.push_back(std::round(1e3 * track[i].x_m) / 1e3);
    y.push_back(std::round(1e3 * track[i].z_m) / 1e3);
  }
  return {{"type", "scatter"}, {"mode", "lines"}, {"x", x}, {"y", y}, {"showlegend", false}};
}

class Panels {
 public:
  Panels(const std::vector<const DrawnRun*>& runs, const Extent& extent) : extent_(extent) {
    columns_ = runs.size() == 1 ? 1 : runs.size() == 2 || runs.size() == 4 ? 2 : 3;
    rows_ = static_cast<int>((runs.size() + columns_ - 1) / columns_);
    const double aspect = (extent.z_high - extent.z_low) / (extent.x_high - extent.x_low);
    panel_width_px_ = columns_ == 1 ? 520 : columns_ == 2 ? 330 : 260;
    panel_height_px_ = static_cast<int>(panel_width_px_ * std::clamp(aspect, 0.35, 1.5));
    inner_height_px_ = rows_ * panel_height_px_ + (rows_ - 1) * kGapY_px;
    inner_width_px_ = columns_ * panel_width_px_ + (columns_ - 1) * kGapX_px;
    layout_ = BaseLayout(inner_height_px_ + kTop_px + kBottom_px, kTop_px, kBottom_px);
    for (std::size_t i = 0; i < runs.size(); ++i) AddAxes(i, runs.size());
  }
  void Add(std::size_t panel, Json trace) {
    trace["xaxis"] = Name("x", panel);
    trace["yaxis"] = Name("y", panel);
    data_.push_back(std::move(trace));
  }
  void Title(std::size_t panel, const std::string& text, const std::string& colour) {
    layout_["annotations"].push_back({{"xref", Name("x", panel, " domain")},
                                      {"yref", Name("y", panel, " domain")},
                                      {"x", 0},
                                      {"y", 1},
                                      {"xanchor", "left"},
                                      {"yanchor", "bottom"},
                                      {"text", "<b>" + PlotText(text) + "</b>"},
                                      {"font", {{"color", colour}, {"size", 13}}},
                                      {"showarrow", false}});
  }
  // Labels the start of a track, on the side away from the track.
  void Label(std::size_t panel, const Track& track, const std::string& name) {
    const GroundPoint& at = track.front();
    const bool below = track.back().z_m > at.z_m;
    const bool at_right = at.x_m > 0.3 * extent_.x_low + 0.7 * extent_.x_high;
    layout_["annotations"].push_back({{"xref", Name("x", panel)},
                                      {"yref", Name("y", panel)},
                                      {"x", Rounded(at.x_m)},
                                      {"y", Rounded(at.z_m)},
                                      {"xanchor", at_right ? "right" : "left"},
                                      {"yanchor", below ? "top" : "bottom"},
                                      {"yshift", below ? -3 : 3},
                                      {"text", PlotText(name)},
                                      {"font", {{"size", 10}}},
                                      {"xshift", at_right ? -4 : 4},
                                      {"showarrow", false}});
  }
  int width_px() const { return inner_width_px_ + 70 + 16; }
  int height_px() const { return layout_["height"].get<int>(); }
  std::string Text() const { return PlotJson(data_, layout_); }

 private:
  static constexpr int kGapX_px = 24;
  static constexpr int kGapY_px = 48;
  static constexpr int kTop_px = 50;
  static constexpr int kBottom_px = 54;

  static std::string Name(const char* axis, std::size_t panel, const char* after = "") {
    return panel == 0 ? StrCat(axis, after) : StrCat(axis, panel + 1, after);
  }

  void AddAxes(std::size_t panel, std::size_t panels) {
    const int column = static_cast<int>(panel) % columns_;
    const int row = static_cast<int>(panel) / columns_;
    const bool last_in_column = panel + static_cast<std::size_t>(columns_) >= panels;
    const double left =
        static_cast<double>(column * (panel_width_px_ + kGapX_px)) / inner_width_px_;
    const double top =
        1.0 - static_cast<double>(row * (panel_height_px_ + kGapY_px)) / inner_height_px_;
    Json x = AxisOf(last_in_column ? "x, right (m)" : "");
    x.update({{"domain",
               {Rounded(left, 6),
                Rounded(left + static_cast<double>(panel_width_px_) / inner_width_px_, 6)}},
              {"anchor", Name("y", panel)},
              {"range", {Rounded(extent_.x_low), Rounded(extent_.x_high)}},
              {"constrain", "domain"},
              {"nticks", 6}});
    Json y = AxisOf(column == 0 ? "z, ahead (m)" : "");
    y.update(
        {{"domain",
          {Rounded(std::max(top - static_cast<double>(panel_height_px_) / inner_height_px_, 0.0),
                   6),
           Rounded(top, 6)}},
         {"anchor", Name("x", panel)},
         {"range", {Rounded(extent_.z_low), Rounded(extent_.z_high)}},
         {"constrain", "domain"},
         {"showticklabels", column == 0},
         {"nticks", 6}});
    // The other panels match the first one, and thereby its scale.
    if (panel == 0) y["scaleanchor"] = "x";
    if (panel > 0) {
      x["matches"] = "x";
      y["matches"] = "y";
    }
    layout_[Name("xaxis", panel)] = std::move(x);
    layout_[Name("yaxis", panel)] = std::move(y);
  }

  const Extent& extent_;
  int columns_ = 1;
  int rows_ = 1;
  int panel_width_px_ = 0;
  int panel_height_px_ = 0;
  int inner_width_px_ = 0;
  int inner_height_px_ = 0;
  Json data_ = Json::array();
  Json layout_;
};

struct LineStyle {
  std::string colour;
  const char* dash = "solid";
  double width = 1.5;
};

void AddLine(const Track& track, const std::string& name, const LineStyle& style, std::size_t panel,
             Panels& panels) {
  if (track.empty()) return;
  Json line = LineOf(track);
  line.update({{"line", {{"color", style.colour}, {"dash", style.dash}, {"width", style.width}}},
               {"hovertemplate", StrCat(PlotText(name), ": x %{x} m, z %{y} m<extra></extra>")}});
  panels.Add(panel, std::move(line));
}

void AddStarts(const std::vector<Track>& tracks, const std::string& colour, std::size_t panel,
               Panels& panels) {
  Json x = Json::array();
  Json y = Json::array();
  for (const Track& track : tracks) {
    if (track.empty()) continue;
    x.push_back(Rounded(track.front().x_m));
    y.push_back(Rounded(track.front().z_m));
  }
  panels.Add(panel, {{"type", "scatter"},
                     {"mode", "markers"},
                     {"x", x},
                     {"y", y},
                     {"showlegend", false},
                     {"hovertemplate", "start<extra></extra>"},
                     {"marker", {{"symbol", "circle"}, {"size", 7}, {"color", colour}}}});
}

void DrawRun(const DrawnRun& run, const Style& style, std::size_t panel, Panels& panels) {
  std::vector<Track> truths = {CameraTrack(run.detail, true)};
  std::vector<Track> estimates = {CameraTrack(run.detail, false)};
  AddLine(truths[0], "camera, truth", {kTruthColour, "solid", 5.0}, panel, panels);
  for (const BodyDetail& body : run.detail.bodies) {
    if (!body.mover) continue;
    truths.push_back(TruthTrack(body));
    AddLine(truths.back(), body.name + ", truth", {kTruthColour, "solid", 3.0}, panel, panels);
    if (!truths.back().empty()) panels.Label(panel, truths.back(), body.name);
    estimates.push_back(EstimatedTrack(body));
  }
  if (!truths[0].empty() || !estimates[0].empty()) {
    panels.Label(panel, truths[0].empty() ? estimates[0] : truths[0], "camera");
  }
  AddLine(estimates[0], "camera, " + run.variant, {style.colour, "solid", 1.6}, panel, panels);
  std::size_t next = 1;
  for (const BodyDetail& body : run.detail.bodies) {
    if (!body.mover) continue;
    AddLine(estimates[next++], StrCat(body.name, ", ", run.variant), {style.colour, "solid", 1.3},
            panel, panels);
  }
  AddStarts(truths, kTruthColour, panel, panels);
  panels.Title(panel, run.variant, style.colour);
}

void AddLegend(Panels& panels) {
  const auto add = [&](const char* name, const char* mode, double width) {
    panels.Add(0, {{"type", "scatter"},
                   {"x", {nullptr}},
                   {"y", {nullptr}},
                   {"mode", mode},
                   {"name", name},
                   {"hoverinfo", "skip"},
                   {"line", {{"color", kTruthColour}, {"width", width}}},
                   {"marker", {{"color", kTruthColour}, {"size", 7}}}});
  };
  add("truth (camera bold)", "lines", 4.0);
  add("start", "markers", 1.0);
}

// The truth determines the extent, so that an estimate that drifts far away does not shrink the
// drawing.
Extent ExtentOf(const std::vector<const DrawnRun*>& runs) {
  Extent extent;
  Extent all;
  for (const DrawnRun* run : runs) {
    extent.Add(CameraTrack(run->detail, true));
    all.Add(CameraTrack(run->detail, false));
    for (const BodyDetail& body : run->detail.bodies) {
      if (body.mover) extent.Add(TruthTrack(body));
    }
  }
  if (extent.IsEmpty()) extent = all;
  extent.Widen();
  return extent;
}

double EndError(const Track& estimate, const Track& truth) {
  for (auto e = estimate.rbegin(); e != estimate.rend(); ++e) {
    for (const GroundPoint& t : truth) {
      if (t.frame == e->frame) return std::hypot(t.x_m - e->x_m, t.z_m - e->z_m);
    }
  }
  return -1.0;
}

std::string TrajectoryErrorText(const DrawnRun& run) {
  std::string text = run.variant + ": ";
  const double camera_m = EndError(CameraTrack(run.detail, false), CameraTrack(run.detail, true));
  text += camera_m < 0.0
              ? "camera without truth"
              : StrCat("camera ends ", NumberText(100.0 * camera_m, 2), " cm from the truth");
  for (const BodyDetail& body : run.detail.bodies) {
    if (!body.mover) continue;
    double sum = 0.0;
    for (const BodyPosition& position : body.estimated) sum += position.error_m;
    text += StrCat("; ", body.name, " ");
    text += body.estimated.empty()
                ? "not estimated"
                : StrCat(NumberText(100.0 * sum / static_cast<double>(body.estimated.size()), 2),
                         " cm off on average");
  }
  return text + ". ";
}

bool LeavesExtent(const DrawnRun& run, const Extent& extent) {
  if (!extent.Holds(CameraTrack(run.detail, false))) return true;
  return std::any_of(
      run.detail.bodies.begin(), run.detail.bodies.end(),
      [&](const BodyDetail& body) { return body.mover && !extent.Holds(EstimatedTrack(body)); });
}

}  // namespace

void DrawTrajectories(const SuiteData& data, SuiteDrawing& drawing) {
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    std::vector<const DrawnRun*> runs = scene.runs;
    if (runs.size() > kMaxPanels) runs.resize(kMaxPanels);
    const Extent extent = ExtentOf(runs);
    if (extent.x_high <= extent.x_low || !std::isfinite(extent.x_high - extent.x_low)) {
      drawing.not_drawn.push_back(StrCat("Trajectories on ", scene.sequence, ": no poses."));
      continue;
    }
    Panels panels(runs, extent);
    Figure figure;
    figure.alt = StrCat("Map of the camera and of moving bodies from above on ", scene.sequence,
                        ", ", NumberText(extent.x_high - extent.x_low, 2), " by ",
                        NumberText(extent.z_high - extent.z_low, 2), " m. ");
    AddLegend(panels);
    std::vector<std::string> cut;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      DrawRun(*runs[i], palette.Of(runs[i]->variant), i, panels);
      figure.alt += TrajectoryErrorText(*runs[i]);
      if (LeavesExtent(*runs[i], extent)) cut.push_back(runs[i]->variant);
    }
    figure.alt.pop_back();
    figure.id = "trajectories-" + Slug(scene.sequence);
    figure.group = "Trajectories";
    figure.title = StrCat("Trajectories from above on ", scene.sequence, ", ", SeedText(scene),
                          ". ", Capitalised(kTruthAlignment));
    figure.caption =
        "Grey: truth, the camera in bold; coloured: the estimate. The world is that of the first "
        "left camera; both axes have one scale. Bodies are drawn where their estimate counts.";
    if (!cut.empty())
      figure.caption += StrCat(" The estimate leaves the part shown: ", Listed(cut), ".");
    if (runs.size() < scene.runs.size()) {
      figure.caption +=
          StrCat(" ", scene.runs.size() - runs.size(), " more variants are not shown.");
    }
    figure.width_px = panels.width_px();
    figure.height_px = panels.height_px();
    figure.plotly = panels.Text();
    drawing.figures.push_back(std::move(figure));
  }
}

}  // namespace cvo::reports
