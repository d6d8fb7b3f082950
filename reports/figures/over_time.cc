// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/suite_figures.h"

namespace cvo::reports {
namespace {

constexpr int kDotted = 4;

const BodyDetail* FindBody(const DrawnRun& run, int id) {
  return FindBy(run.detail.bodies, &BodyDetail::id, id);
}

// The moving bodies that at least one run estimates: those visible in most frames, by id.
std::vector<const BodyDetail*> ChooseBodies(const DrawnScene& scene) {
  constexpr std::size_t kMost = 6;
  std::map<int, const BodyDetail*> found;
  for (const DrawnRun* run : scene.runs) {
    for (const BodyDetail& body : run->detail.bodies) {
      if (body.mover && !body.estimated.empty()) found.try_emplace(body.id, &body);
    }
  }
  std::vector<const BodyDetail*> bodies;
  for (const auto& [id, body] : found) bodies.push_back(body);
  std::stable_sort(bodies.begin(), bodies.end(), [](const BodyDetail* a, const BodyDetail* b) {
    return a->visible.size() > b->visible.size();
  });
  bodies.resize(std::min(bodies.size(), kMost));
  std::sort(bodies.begin(), bodies.end(),
            [](const BodyDetail* a, const BodyDetail* b) { return a->id < b->id; });
  return bodies;
}

// Unit and axis scale for the errors of a scene.
struct ErrorScale {
  double from_m = 100.0;
  const char* unit = "cm";
  bool log = false;

  // At least 0.01 on a logarithmic axis: a body that is estimated only once has an error of 0.
  double Shown(double error_m) const {
    return log ? std::max(from_m * error_m, 0.01) : from_m * error_m;
  }
};

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

std::vector<Datum> ErrorsOf(const std::vector<BodyPosition>& positions, const ErrorScale& scale) {
  Track track;
  for (const BodyPosition& position : positions) {
    track.Add(position.frame, position.frame, scale.Shown(position.error_m));
  }
  return track.data;
}

// Adds what one run estimates of a body.
void AddRun(const DrawnRun& run, const BodyDetail& body, const ErrorScale& scale, Look look,
            Panel& panel) {
  if (!body.estimated.empty()) {
    const double rmse = RootMeanSquare(body.estimated, &BodyPosition::error_m).value();
    panel.series.push_back(
        {SeriesKind::kLine, run.variant, look, ErrorsOf(body.estimated, scale),
         StrCat(run.variant, ": ", NumberText(scale.from_m * rmse, 2), " ", scale.unit,
                " root mean square in ", Counted(body.estimated.size(), "frame"))});
  }
  look.dash = kDotted;
  if (!body.predicted.empty()) {
    panel.series.push_back({SeriesKind::kLine, "", look, ErrorsOf(body.predicted, scale),
                            run.variant + ", predicted"});
  }
}

// Spans of frames in which the body has a true pose but is not visible.
std::vector<Shade> HiddenSpans(const BodyDetail& body) {
  std::vector<Shade> spans;
  bool open = false;
  for (const auto& [frame, pose] : body.truth) {
    const bool hidden = !std::binary_search(body.visible.begin(), body.visible.end(), frame);
    if (hidden && !open) spans.push_back({frame - 0.5, 0.0});
    if (hidden) spans.back().high = frame + 0.5;
    open = hidden;
  }
  return spans;
}

Figure ErrorFigure(const DrawnScene& scene, const std::vector<const BodyDetail*>& bodies,
                   const Palette& palette) {
  const ErrorScale scale = ScaleOf(scene, bodies);
  Chart chart;
  chart.share_x = true;
  for (const BodyDetail* drawn : bodies) {
    Panel& panel = chart.panels.emplace_back();
    panel.x.title = "frame";
    panel.y = {StrCat(drawn->name, " error (", scale.unit, ")"),
               scale.log ? AxisScale::kLog : AxisScale::kLinear};
    panel.y.from_zero = true;
    panel.aspect = 0.19;
    panel.shades = HiddenSpans(*drawn);
    for (const DrawnRun* run : scene.runs) {
      const BodyDetail* body = FindBody(*run, drawn->id);
      if (body != nullptr) AddRun(*run, *body, scale, palette.Line(run->variant), panel);
    }
  }
  std::string caption =
      "Dotted: predicted by the motion model alone. Gaps: no estimate that counts. Shaded: the "
      "body is not visible.";
  if (scale.log) caption += " The scale of errors is logarithmic.";
  return {"error-over-time-" + Slug(scene.sequence),
          StrCat("Position error of moving bodies on ", SceneText(scene)), caption,
          std::move(chart)};
}

}  // namespace

void AddErrorOverTime(const SuiteData& data, SuiteFigures& figures) {
  const Palette palette = PaletteOfDrawn(data);
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    const std::vector<const BodyDetail*> bodies = ChooseBodies(scene);
    if (bodies.empty()) {
      figures.not_drawn.push_back(
          StrCat("Error over time on ", scene.sequence,
                 ": no moving body with truth is estimated in the runs read."));
      continue;
    }
    figures.figures.push_back(ErrorFigure(scene, bodies, palette));
  }
}

}  // namespace cvo::reports
