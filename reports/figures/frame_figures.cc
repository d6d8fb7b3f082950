// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Figures of what single runs estimate frame by frame: errors over time, and paths from above.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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
  double Of(double error_m) const {
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
      for (const auto* list : {&body->estimated, &body->predicted}) {
        for (const BodyPosition& position : *list) errors.push_back(position.error_m);
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  const double middle = Median(errors);
  const double most =
      errors[static_cast<std::size_t>(0.98 * static_cast<double>(errors.size() - 1))];
  return {middle >= 0.5 ? 1.0 : 100.0, middle >= 0.5 ? "m" : "cm",
          middle > 0.0 && most / middle > kWideRatio};
}

std::vector<Datum> ErrorsOf(const std::vector<BodyPosition>& positions, const ErrorScale& scale) {
  Track track;
  for (const BodyPosition& position : positions) {
    track.Add(position.frame, position.frame, scale.Of(position.error_m));
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
  std::vector<std::string> without;
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    const std::vector<const BodyDetail*> bodies = ChooseBodies(scene);
    if (bodies.empty()) {
      without.push_back(scene.sequence);
    } else {
      figures.figures.push_back(ErrorFigure(scene, bodies, palette));
    }
  }
  if (without.empty()) return;
  figures.not_drawn.push_back(
      StrCat("Error over time on ", without.front(),
             without.size() > 1 ? StrCat(" and ", without.size() - 1, " more") : "",
             ": no moving body with truth is estimated in the runs read."));
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Paths are seen from above: x is to the right of the first camera, y ahead of it (z of the world).
Track CameraTrack(const RunDetail& detail, bool truth) {
  Track track;
  for (const CameraFrame& frame : detail.camera) {
    if (truth ? !frame.truth : frame.status == "skipped") continue;
    const Pose& pose = truth ? *frame.truth : frame.world_from_camera;
    track.Add(frame.frame, pose[0], pose[2]);
  }
  return track;
}

// The true track from the first frame in which the body is visible to the last.
Track TruthTrack(const BodyDetail& body) {
  Track track;
  for (const auto& [frame, pose] : body.truth) {
    if (body.visible.empty() || frame < body.visible.front() || frame > body.visible.back()) {
      continue;
    }
    track.Add(frame, pose[0], pose[2]);
  }
  return track;
}

Track EstimatedTrack(const BodyDetail& body) {
  Track track;
  for (const BodyPosition& position : body.estimated) {
    track.Add(position.frame, position.position_m[0], position.position_m[2]);
  }
  return track;
}

// The range of x and z. The truth determines it, so that an estimate that drifts far away does not
// shrink the drawing. Empty if there are no poses.
std::optional<std::array<ValueRange, 2>> ExtentOf(const std::vector<const DrawnRun*>& runs) {
  for (const bool truth : {true, false}) {
    std::vector<Track> tracks;
    for (const DrawnRun* run : runs) {
      tracks.push_back(CameraTrack(run->detail, truth));
      for (const BodyDetail& body : run->detail.bodies) {
        if (body.mover && truth) tracks.push_back(TruthTrack(body));
      }
    }
    ValueRange x{kInfinity, -kInfinity};
    ValueRange z = x;
    for (const Track& track : tracks) {
      for (const Datum& point : track.data) {  // fmin and fmax ignore gaps
        x = {std::fmin(x.low, point.x), std::fmax(x.high, point.x)};
        z = {std::fmin(z.low, point.y), std::fmax(z.high, point.y)};
      }
    }
    if (x.low > x.high) continue;
    const double margin = 0.06 * std::max({x.high - x.low, z.high - z.low, 0.1});
    return std::array{ValueRange{x.low - margin, x.high + margin},
                      ValueRange{z.low - margin, z.high + margin}};
  }
  return std::nullopt;
}

// A track with its truth, and its name beside the start.
void AddTrack(const std::string& name, const Track& truth, const Track& estimate, const Look& look,
              Panel& panel) {
  const bool camera = name == "camera";
  panel.series.push_back({SeriesKind::kLine,
                          camera && !truth.data.empty() ? "truth (camera bold)" : "",
                          {0, Symbol::kNone, 0, camera ? 3.0 : 2.0},
                          truth.data,
                          name + ", truth"});
  panel.series.push_back(
      {SeriesKind::kLine, "", look, estimate.data, StrCat(name, ", ", panel.title)});
  const std::vector<Datum>& path = truth.data.empty() ? estimate.data : truth.data;
  if (path.empty()) return;
  Datum start = path.front();
  start.text = name;
  start.text_below = path.back().y > start.y;
  panel.series.push_back({SeriesKind::kPoints, "start", {0, Symbol::kCircle}, {start}});
}

Panel PathPanel(const DrawnRun& run, const Look& look, const std::array<ValueRange, 2>& extent) {
  Panel panel;
  panel.title = run.variant;
  panel.x.title = "x, right (m)";
  panel.x.low = extent[0].low;
  panel.x.high = extent[0].high;
  panel.y.title = "z, ahead (m)";
  panel.y.low = extent[1].low;
  panel.y.high = extent[1].high;
  panel.equal_scale = true;
  panel.aspect = 1.3;
  AddTrack("camera", CameraTrack(run.detail, true), CameraTrack(run.detail, false), look, panel);
  for (const BodyDetail& body : run.detail.bodies) {
    if (body.mover) AddTrack(body.name, TruthTrack(body), EstimatedTrack(body), look, panel);
  }
  return panel;
}

}  // namespace

void AddTrajectories(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMaxPanels = 9;
  const Palette palette = PaletteOfDrawn(data);
  for (DrawnScene& scene : GroupByScene(data.drawn)) {
    std::string caption = "Grey: truth; coloured: the estimate, of bodies where it counts.";
    if (scene.runs.size() > kMaxPanels) {
      caption += StrCat(" ", scene.runs.size() - kMaxPanels, " more variants are not shown.");
      scene.runs.resize(kMaxPanels);
    }
    const auto extent = ExtentOf(scene.runs);
    if (!extent) {
      figures.not_drawn.push_back(StrCat("Trajectories on ", scene.sequence, ": no poses."));
      continue;
    }
    const std::size_t count = scene.runs.size();
    Chart chart;
    chart.columns = count == 1 ? 1 : count == 2 || count == 4 ? 2 : 3;
    chart.width = count == 1 ? 0.75 : 1.0;
    chart.share_x = true;
    chart.share_y = true;
    for (const DrawnRun* run : scene.runs) {
      chart.panels.push_back(PathPanel(*run, palette.Line(run->variant), *extent));
    }
    figures.figures.push_back({"trajectories-" + Slug(scene.sequence),
                               StrCat("Trajectories from above on ", SceneText(scene)), caption,
                               std::move(chart)});
  }
}

}  // namespace cvo::reports
