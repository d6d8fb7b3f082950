// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>

#include "core/base/lists.h"
#include "core/base/mean.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite/drawn_scenes.h"
#include "reports/figures/suite/error_marks.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxBodies = 6;
constexpr int kCurveWidth_px = 720;

const BodyDetail* FindBody(const DrawnRun& run, int id) {
  return FindBy(run.detail.bodies, &BodyDetail::id, id);
}

// The moving bodies that at least one run estimates, limited to those visible in most frames,
// ordered by id.
struct SceneBodies {
  std::vector<const BodyDetail*> drawn;
  std::size_t left_out = 0;
  std::vector<std::string> never;  // estimated by no run
};

SceneBodies ChooseBodies(const DrawnScene& scene) {
  std::map<int, std::pair<const BodyDetail*, bool>> found;
  for (const DrawnRun* run : scene.runs) {
    for (const BodyDetail& body : run->detail.bodies) {
      if (!body.mover) continue;
      auto& [known, estimated] = found.try_emplace(body.id, &body, false).first->second;
      estimated = estimated || !body.estimated.empty();
    }
  }
  SceneBodies bodies;
  for (const auto& [id, body] : found) {
    if (body.second) bodies.drawn.push_back(body.first);
    if (!body.second) bodies.never.push_back(body.first->name);
  }
  std::stable_sort(bodies.drawn.begin(), bodies.drawn.end(),
                   [](const BodyDetail* a, const BodyDetail* b) {
                     return a->visible.size() > b->visible.size();
                   });
  if (bodies.drawn.size() > kMaxBodies) {
    bodies.left_out = bodies.drawn.size() - kMaxBodies;
    bodies.drawn.resize(kMaxBodies);
  }
  std::sort(bodies.drawn.begin(), bodies.drawn.end(),
            [](const BodyDetail* a, const BodyDetail* b) { return a->id < b->id; });
  return bodies;
}

// Whether the run has estimates or predictions of any of these bodies.
bool Shows(const DrawnRun& run, const SceneBodies& bodies) {
  return std::any_of(bodies.drawn.begin(), bodies.drawn.end(), [&](const BodyDetail* drawn) {
    const BodyDetail* body = FindBody(run, drawn->id);
    return body != nullptr && !(body->estimated.empty() && body->predicted.empty());
  });
}

ErrorScale ScaleOf(const DrawnScene& scene, const SceneBodies& bodies) {
  constexpr double kWideRatio = 15.0;
  std::vector<double> errors;
  for (const DrawnRun* run : scene.runs) {
    for (const BodyDetail* drawn : bodies.drawn) {
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

std::optional<int> FirstFrameOf(const DrawnRun& run, std::int64_t cluster) {
  for (const ClusterRow& row : run.detail.clusters) {
    if (row.id == cluster) return row.frame;
  }
  return std::nullopt;
}

constexpr char kBirth[] = "triangle-up-open";
constexpr char kSwitch[] = "x-thin-open";

void DrawRun(const DrawnRun& run, const BodyDetail& body, const ErrorScale& scale,
             const Style& style, std::size_t panel, Plot& plot) {
  const auto add = [&](const std::vector<BodyPosition>& positions, const char* dash, double width,
                       const char* what) {
    if (positions.empty()) return;
    Json trace = ErrorLine(positions, scale);
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

// Shades spans of frames in which the body has a true pose but is not visible. Returns whether
// there are any.
bool ShadeHidden(const BodyDetail& body, std::size_t panel, Plot& plot) {
  const auto hidden = [&](int frame) {
    return !std::binary_search(body.visible.begin(), body.visible.end(), frame);
  };
  bool any = false;
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
    any = true;
    i = last;
  }
  return any;
}

// The kinds of marks drawn in a figure, for its legend and caption.
struct DrawnMarks {
  bool predictions = false;
  bool births = false;
  bool switches = false;
  bool shades = false;
};

// Adds separate traces for the legend, so that it is complete whatever the first panel contains.
void AddLegend(const DrawnScene& scene, const SceneBodies& bodies, const Palette& palette,
               const DrawnMarks& marks, Plot& plot) {
  const auto add = [&](Json trace) {
    trace.update({{"type", "scatter"}, {"x", {nullptr}}, {"y", {nullptr}}, {"hoverinfo", "skip"}});
    plot.AddTrace(0, std::move(trace));
  };
  const auto add_mark = [&](const char* name, const char* symbol) {
    add({{"mode", "markers"},
         {"name", name},
         {"marker",
          {{"symbol", symbol},
           {"size", 9},
           {"color", kTruthColour},
           {"line", {{"color", kTruthColour}, {"width", 2}}}}}});
  };
  for (const DrawnRun* run : scene.runs) {
    if (!Shows(*run, bodies)) continue;
    add({{"mode", "lines"},
         {"name", PlotText(run->variant)},
         {"legendgroup", PlotText(run->variant)},
         {"line", {{"color", palette.Of(run->variant).colour}, {"width", 2}}}});
  }
  if (marks.predictions) {
    add({{"mode", "lines"},
         {"name", "predicted"},
         {"line", {{"color", kTruthColour}, {"dash", "dot"}}}});
  }
  if (marks.births) add_mark("cluster begins", kBirth);
  if (marks.switches) add_mark("identity switch", kSwitch);
}

std::string BodyErrorText(const DrawnScene& scene, const BodyDetail& drawn,
                          const ErrorScale& scale) {
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
    double most = 0.0;
    for (const BodyPosition& position : body->estimated) most = std::max(most, position.error_m);
    const double rmse = RootMeanSquare(body->estimated, &BodyPosition::error_m).value();
    text +=
        StrCat(NumberText(scale.from_m * rmse, 2), " ", scale.unit, " root mean square, at most ",
               NumberText(scale.from_m * most, 2), ", in ", body->estimated.size(), " frames");
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

std::string Caption(const DrawnScene& scene, const SceneBodies& bodies, const ErrorScale& scale,
                    const DrawnMarks& marks) {
  std::string text = "Dotted: predicted by the motion model alone. Gaps: no estimate that counts. ";
  if (marks.shades) {
    text += "Shaded: the body is not visible: hidden, too small or out of the image. ";
  }
  if (scale.log) text += "The scale of errors is logarithmic. ";
  std::vector<std::string> silent;
  std::vector<std::string> unknown;
  for (const DrawnRun* run : scene.runs) {
    if (!Shows(*run, bodies)) silent.push_back(run->variant);
    if (!run->switches) unknown.push_back(run->variant);
  }
  if (!silent.empty())
    text += StrCat("Without an estimate of these bodies: ", Listed(silent), ". ");
  if (!unknown.empty()) {
    text += StrCat("Identity switches not known, no landmarks.csv: ", Listed(unknown), ". ");
  }
  if (!bodies.never.empty()) text += StrCat("Estimated by none: ", Listed(bodies.never), ". ");
  if (bodies.left_out > 0) {
    text += StrCat(bodies.left_out, " bodies that are visible in fewer frames are not shown. ");
  }
  text.pop_back();
  return text;
}

// Draws one panel: one body as estimated by all runs.
void DrawBody(const DrawnScene& scene, const BodyDetail& drawn, std::size_t panel,
              const ErrorScale& scale, const Palette& palette, DrawnMarks& marks, Plot& plot) {
  marks.shades = ShadeHidden(drawn, panel, plot) || marks.shades;
  FrameMarks births(kBirth, "cluster begins");
  FrameMarks switches(kSwitch, "identity switch");
  for (const DrawnRun* run : scene.runs) {
    const BodyDetail* body = FindBody(*run, drawn.id);
    if (body == nullptr) continue;
    const Style& style = palette.Of(run->variant);
    DrawRun(*run, *body, scale, style, panel, plot);
    marks.predictions = marks.predictions || !body->predicted.empty();
    const auto birth = FirstFrameOf(*run, body->cluster);
    if (birth) births.Add(*body, *birth, *run, scale, style);
    if (!run->switches) continue;
    for (const IdentitySwitch& change : *run->switches) {
      if (change.body == body->id) switches.Add(*body, change.frame, *run, scale, style);
    }
  }
  marks.births = marks.births || !births.empty();
  marks.switches = marks.switches || !switches.empty();
  if (!births.empty()) plot.AddTrace(panel, births.Trace());
  if (!switches.empty()) plot.AddTrace(panel, switches.Trace());
}

Figure DrawScene(const SuiteData& data, const DrawnScene& scene, const SceneBodies& bodies) {
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  const ErrorScale scale = ScaleOf(scene, bodies);
  std::vector<Panel> panels;
  for (const BodyDetail* body : bodies.drawn) panels.push_back(PanelOf(*body, scale));
  std::vector<std::string> entries = VariantsOf(data.drawn);
  entries.insert(entries.end(), {"predicted", "cluster begins", "identity switch"});
  Plot plot(AxisOf("frame"), panels, LegendHeight(entries, kCurveWidth_px));
  DrawnMarks marks;
  for (std::size_t i = 0; i < bodies.drawn.size(); ++i) {
    DrawBody(scene, *bodies.drawn[i], i, scale, palette, marks, plot);
  }
  AddLegend(scene, bodies, palette, marks, plot);
  Figure figure;
  figure.id = "error-over-time-" + Slug(scene.sequence);
  figure.group = "Error over time";
  figure.title = StrCat("Position error of moving bodies on ", scene.sequence, ", ",
                        SeedText(scene), ". Per frame, ", kTruthAlignment);
  figure.caption = Caption(scene, bodies, scale, marks);
  figure.alt =
      StrCat("Lines of position error over frames on ", scene.sequence, ", one panel per body. ");
  for (const BodyDetail* body : bodies.drawn) figure.alt += BodyErrorText(scene, *body, scale);
  figure.alt.pop_back();
  figure.width_px = kCurveWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  return figure;
}

}  // namespace

void DrawErrorOverTime(const SuiteData& data, SuiteDrawing& drawing) {
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    const SceneBodies bodies = ChooseBodies(scene);
    if (bodies.drawn.empty()) {
      drawing.not_drawn.push_back(
          StrCat("Error over time on ", scene.sequence,
                 ": no moving body with truth is estimated in the runs read."));
      continue;
    }
    drawing.figures.push_back(DrawScene(data, scene, bodies));
  }
}

}  // namespace cvo::reports
