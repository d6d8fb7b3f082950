// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "reports/figures/drawn_scenes.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMostBodies = 6;

// How the errors of a scene are shown.
struct ErrorScale {
  double from_m = 100.0;
  const char* unit = "cm";
  bool log = false;
};

const BodyDetail* FindBody(const DrawnRun& run, int id) {
  for (const BodyDetail& body : run.detail.bodies) {
    if (body.id == id) return &body;
  }
  return nullptr;
}

// Moving bodies that some run estimates, most visible first; then by id.
std::vector<const BodyDetail*> BodiesToDraw(const DrawnScene& scene, std::size_t& left_out,
                                            std::vector<std::string>& never) {
  std::map<int, std::pair<const BodyDetail*, bool>> bodies;
  for (const DrawnRun* run : scene.runs) {
    for (const BodyDetail& body : run->detail.bodies) {
      if (!body.mover) continue;
      auto& [known, estimated] = bodies.try_emplace(body.id, &body, false).first->second;
      estimated = estimated || !body.estimated.empty();
    }
  }
  std::vector<const BodyDetail*> drawn;
  for (const auto& [id, body] : bodies) {
    if (body.second) drawn.push_back(body.first);
    if (!body.second) never.push_back(body.first->name);
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const BodyDetail* a, const BodyDetail* b) {
    return a->visible.size() > b->visible.size();
  });
  left_out = drawn.size() > kMostBodies ? drawn.size() - kMostBodies : 0;
  if (left_out > 0) drawn.resize(kMostBodies);
  std::sort(drawn.begin(), drawn.end(),
            [](const BodyDetail* a, const BodyDetail* b) { return a->id < b->id; });
  return drawn;
}

ErrorScale ScaleOf(const DrawnScene& scene, const std::vector<const BodyDetail*>& bodies) {
  constexpr double kWideRatio = 15.0;
  std::vector<double> errors;
  for (const DrawnRun* run : scene.runs) {
    for (const BodyDetail* drawn : bodies) {
      const BodyDetail* body = FindBody(*run, drawn->id);
      if (body == nullptr) continue;
      for (const BodyPosition& position : body->estimated) errors.push_back(position.error_m);
      for (const BodyPosition& position : body->predicted) errors.push_back(position.error_m);
    }
  }
  std::sort(errors.begin(), errors.end());
  const auto quantile = [&](double q) {
    return errors[static_cast<std::size_t>(q * static_cast<double>(errors.size() - 1))];
  };
  ErrorScale scale;
  if (quantile(0.5) >= 0.5) scale = {1.0, "m", false};
  scale.log = quantile(0.5) > 0.0 && quantile(0.98) / quantile(0.5) > kWideRatio;
  return scale;
}

// A line that is broken where frames are missing.
Json Line(const std::vector<BodyPosition>& positions, const ErrorScale& scale) {
  Json x = Json::array();
  Json y = Json::array();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0 && positions[i].frame > positions[i - 1].frame + 1) {
      x.push_back(positions[i].frame);
      y.push_back(nullptr);
    }
    x.push_back(positions[i].frame);
    const double error = scale.from_m * positions[i].error_m;
    y.push_back(Rounded(scale.log ? std::max(error, 1e-3) : error, 3));
  }
  return {{"type", "scatter"}, {"x", x}, {"y", y}, {"showlegend", false}};
}

std::optional<double> ErrorAt(const BodyDetail& body, int frame) {
  std::optional<double> error;
  int nearest = 0;
  for (const auto* positions : {&body.estimated, &body.predicted}) {
    for (const BodyPosition& position : *positions) {
      const int distance = std::abs(position.frame - frame);
      if (error && distance >= nearest) continue;
      error = position.error_m;
      nearest = distance;
    }
  }
  return error;
}

std::optional<int> FirstFrameOf(const DrawnRun& run, std::int64_t cluster) {
  for (const ClusterRow& row : run.detail.clusters) {
    if (row.id == cluster) return row.frame;
  }
  return std::nullopt;
}

// Marks at frames, at the height of the error there or of the nearest one.
class Marks {
 public:
  Marks(const char* symbol, const char* what) : symbol_(symbol), what_(what) {}

  void Add(const BodyDetail& body, int frame, const DrawnRun& run, const ErrorScale& scale,
           const Style& style) {
    const auto error_m = ErrorAt(body, frame);
    if (!error_m) return;
    x_.push_back(frame);
    y_.push_back(Rounded(std::max(scale.from_m * *error_m, scale.log ? 1e-3 : 0.0), 3));
    texts_.push_back(PlotText(run.variant));
    colours_.push_back(style.colour);
  }
  bool empty() const { return x_.empty(); }
  Json Trace() const {
    return {{"type", "scatter"},
            {"mode", "markers"},
            {"x", x_},
            {"y", y_},
            {"text", texts_},
            {"showlegend", false},
            {"hovertemplate", StrCat("%{text}: ", what_, " in frame %{x}<extra></extra>")},
            {"marker",
             {{"symbol", symbol_},
              {"size", 10},
              {"color", colours_},
              {"line", {{"color", colours_}, {"width", 2}}}}}};
  }

 private:
  const char* symbol_;
  const char* what_;
  Json x_ = Json::array();
  Json y_ = Json::array();
  Json texts_ = Json::array();
  Json colours_ = Json::array();
};

constexpr char kBirth[] = "triangle-up-open";
constexpr char kSwitch[] = "x-thin-open";

void DrawRun(const DrawnRun& run, const BodyDetail& body, const ErrorScale& scale,
             const Style& style, std::size_t panel, Plot& plot) {
  const auto add = [&](const std::vector<BodyPosition>& positions, const char* dash, double width,
                       const char* what) {
    if (positions.empty()) return;
    Json trace = Line(positions, scale);
    trace.update({{"mode", positions.size() == 1 ? "markers" : "lines"},
                  {"legendgroup", PlotText(run.variant)},
                  {"line", {{"color", style.colour}, {"dash", dash}, {"width", width}}},
                  {"marker", {{"color", style.colour}, {"size", 4}}},
                  {"hovertemplate", StrCat(PlotText(run.variant), what, ", frame %{x}: %{y} ",
                                           scale.unit, "<extra></extra>")}});
    plot.AddTrace(panel, std::move(trace));
  };
  add(body.estimated, "solid", 1.6, "");
  add(body.predicted, "dot", 1.6, ", predicted");
}

// Spans of frames in which the body has truth but is not visible.
void ShadeHidden(const BodyDetail& body, std::size_t panel, Plot& plot) {
  const auto hidden = [&](int frame) {
    return !std::binary_search(body.visible.begin(), body.visible.end(), frame);
  };
  for (std::size_t i = 0; i < body.truth.size(); ++i) {
    if (!hidden(body.truth[i].first)) continue;
    std::size_t last = i;
    while (last + 1 < body.truth.size() && hidden(body.truth[last + 1].first)) ++last;
    plot.AddShape(panel, {{"type", "rect"},
                          {"x0", body.truth[i].first - 0.5},
                          {"x1", body.truth[last].first + 0.5},
                          {"y0", 0},
                          {"y1", 1},
                          {"layer", "below"},
                          {"line", {{"width", 0}}},
                          {"fillcolor", kShade}});
    i = last;
  }
}

// Legend entries of their own, so that it is whole whatever the first panel holds.
void AddLegend(const DrawnScene& scene, const Palette& palette, bool births, bool switches,
               Plot& plot) {
  const auto add = [&](Json trace) {
    trace.update({{"type", "scatter"}, {"x", {nullptr}}, {"y", {nullptr}}, {"hoverinfo", "skip"}});
    plot.AddTrace(0, std::move(trace));
  };
  for (const DrawnRun* run : scene.runs) {
    add({{"mode", "lines"},
         {"name", PlotText(run->variant)},
         {"legendgroup", PlotText(run->variant)},
         {"line", {{"color", palette.Of(run->variant).colour}, {"width", 2}}}});
  }
  add({{"mode", "lines"},
       {"name", "predicted"},
       {"line", {{"color", kTruthColour}, {"dash", "dot"}}}});
  const Json line = {{"color", kTruthColour}, {"width", 2}};
  if (births) {
    add({{"mode", "markers"},
         {"name", "cluster begins"},
         {"marker", {{"symbol", kBirth}, {"size", 9}, {"color", kTruthColour}, {"line", line}}}});
  }
  if (switches) {
    add({{"mode", "markers"},
         {"name", "identity switch"},
         {"marker", {{"symbol", kSwitch}, {"size", 9}, {"color", kTruthColour}, {"line", line}}}});
  }
}

std::string SayBody(const DrawnScene& scene, const BodyDetail& drawn, const ErrorScale& scale) {
  std::string text =
      StrCat(Capitalised(drawn.name), ", visible in ", drawn.visible.size(), " frames: ");
  bool first = true;
  for (const DrawnRun* run : scene.runs) {
    const BodyDetail* body = FindBody(*run, drawn.id);
    text += StrCat(first ? "" : "; ", run->variant, " ");
    first = false;
    if (body == nullptr || body->estimated.empty()) {
      text += "no estimate";
      continue;
    }
    double squares = 0.0;
    double most = 0.0;
    for (const BodyPosition& position : body->estimated) {
      squares += position.error_m * position.error_m;
      most = std::max(most, position.error_m);
    }
    const double rmse = std::sqrt(squares / static_cast<double>(body->estimated.size()));
    text += StrCat(Say(scale.from_m * rmse, 2), " ", scale.unit, " root mean square, at most ",
                   Say(scale.from_m * most, 2), ", in ", body->estimated.size(), " frames");
    if (!body->predicted.empty()) text += StrCat(" and ", body->predicted.size(), " predicted");
  }
  return text + ". ";
}

Panel PanelOf(const BodyDetail& body, const ErrorScale& scale) {
  Panel panel{AxisOf(""), 118};
  panel.y_axis["title"]["text"] = StrCat(PlotText(body.name), "<br>error (", scale.unit, ")");
  panel.y_axis["nticks"] = 5;
  if (scale.log) {
    panel.y_axis.update(
        {{"type", "log"}, {"dtick", 1}, {"minor", {{"ticks", "outside"}, {"dtick", "D1"}}}});
  } else {
    panel.y_axis["rangemode"] = "tozero";
  }
  return panel;
}

std::string Caption(const DrawnScene& scene, const ErrorScale& scale, std::size_t left_out,
                    const std::vector<std::string>& never, bool switches) {
  std::string text = StrCat(
      "Shaded: the body has truth but is not visible (hidden, too small or out of the image). "
      "Dotted: predicted by the motion model alone. Gaps: no estimate that counts. ");
  if (scale.log) text += "The scale of errors is logarithmic. ";
  if (!switches) text += "Identity switches are not known frame by frame: no landmarks.csv. ";
  if (!never.empty()) text += StrCat("Never estimated: ", Listed(never), ". ");
  if (left_out > 0)
    text += StrCat(left_out, " bodies that are visible in fewer frames are not shown. ");
  for (const DrawnRun* run : scene.runs) {
    if (run->detail.bodies.empty()) text += StrCat(run->variant, ": no truth of bodies. ");
  }
  text.pop_back();
  return text;
}

Figure DrawScene(const SuiteData& data, const DrawnScene& scene,
                 const std::vector<const BodyDetail*>& bodies, std::string caption_end,
                 const ErrorScale& scale) {
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  std::vector<Panel> panels;
  for (const BodyDetail* body : bodies) panels.push_back(PanelOf(*body, scale));
  Plot plot(AxisOf("frame"), panels);
  bool any_birth = false;
  bool any_switch = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ShadeHidden(*bodies[i], i, plot);
    Marks births(kBirth, "cluster begins");
    Marks switches(kSwitch, "identity switch");
    for (const DrawnRun* run : scene.runs) {
      const BodyDetail* body = FindBody(*run, bodies[i]->id);
      if (body == nullptr) continue;
      const Style& style = palette.Of(run->variant);
      DrawRun(*run, *body, scale, style, i, plot);
      const auto birth = FirstFrameOf(*run, body->cluster);
      if (birth) births.Add(*body, *birth, *run, scale, style);
      if (!run->switches) continue;
      for (const IdentitySwitch& change : *run->switches) {
        if (change.body == body->id) switches.Add(*body, change.frame, *run, scale, style);
      }
    }
    any_birth = any_birth || !births.empty();
    any_switch = any_switch || !switches.empty();
    if (!births.empty()) plot.AddTrace(i, births.Trace());
    if (!switches.empty()) plot.AddTrace(i, switches.Trace());
  }
  AddLegend(scene, palette, any_birth, any_switch, plot);
  Figure figure;
  figure.id = "error-over-time-" + Slug(scene.sequence);
  figure.group = "Error over time";
  figure.title = StrCat("Position error of moving bodies on ", scene.sequence, ", ",
                        SeedText(scene), ". Per frame, ", kTruthAlignment);
  figure.caption = std::move(caption_end);
  figure.alt =
      StrCat("Lines of position error over frames on ", scene.sequence, ", one panel per body. ");
  for (const BodyDetail* body : bodies) figure.alt += SayBody(scene, *body, scale);
  figure.alt.pop_back();
  figure.width_px = 720;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  return figure;
}

}  // namespace

void DrawErrorOverTime(const SuiteData& data, SuiteDrawing& drawing) {
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    std::size_t left_out = 0;
    std::vector<std::string> never;
    const auto bodies = BodiesToDraw(scene, left_out, never);
    if (bodies.empty()) {
      drawing.not_drawn.push_back(
          StrCat("Error over time on ", scene.sequence,
                 ": no moving body with truth is estimated in the runs read."));
      continue;
    }
    const ErrorScale scale = ScaleOf(scene, bodies);
    const bool switches =
        std::all_of(scene.runs.begin(), scene.runs.end(),
                    [](const DrawnRun* run) { return run->switches.has_value(); });
    drawing.figures.push_back(
        DrawScene(data, scene, bodies, Caption(scene, scale, left_out, never, switches), scale));
  }
}

}  // namespace cvo::reports
