// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/figure_style.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
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

struct Extent {
  ValueRange x{kInfinity, -kInfinity};
  ValueRange z = x;

  void Add(const Track& track) {
    for (const Datum& point : track.data) {  // min and max ignore gaps
      x = {std::fmin(x.low, point.x), std::fmax(x.high, point.x)};
      z = {std::fmin(z.low, point.y), std::fmax(z.high, point.y)};
    }
  }
  bool IsEmpty() const { return !std::isfinite(x.high - x.low + z.high - z.low); }
};

// The truth determines the extent, so that an estimate that drifts far away does not shrink the
// drawing.
Extent ExtentOf(const std::vector<const DrawnRun*>& runs) {
  Extent extent;
  Extent estimates;
  for (const DrawnRun* run : runs) {
    extent.Add(CameraTrack(run->detail, true));
    estimates.Add(CameraTrack(run->detail, false));
    for (const BodyDetail& body : run->detail.bodies) {
      if (body.mover) extent.Add(TruthTrack(body));
    }
  }
  if (extent.IsEmpty()) extent = estimates;
  const double margin =
      0.06 * std::max({extent.x.high - extent.x.low, extent.z.high - extent.z.low, 0.1});
  for (ValueRange* range : {&extent.x, &extent.z}) {
    *range = {range->low - margin, range->high + margin};
  }
  return extent;
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

Panel PathPanel(const DrawnRun& run, const Look& look, const Extent& extent) {
  Panel panel;
  panel.title = run.variant;
  panel.x.title = "x, right (m)";
  panel.x.low = extent.x.low;
  panel.x.high = extent.x.high;
  panel.y.title = "z, ahead (m)";
  panel.y.low = extent.z.low;
  panel.y.high = extent.z.high;
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
    const Extent extent = ExtentOf(scene.runs);
    if (extent.IsEmpty()) {
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
      chart.panels.push_back(PathPanel(*run, palette.Line(run->variant), extent));
    }
    figures.figures.push_back({"trajectories-" + Slug(scene.sequence),
                               StrCat("Trajectories from above on ", SceneText(scene)), caption,
                               std::move(chart)});
  }
}

}  // namespace cvo::reports
