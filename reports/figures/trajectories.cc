// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

// Seen from above: x is to the right of the first camera, y ahead of it (z of the world). Frames
// without a value are gaps.
using Track = std::vector<Datum>;

void AddPoint(int frame, double x_m, double z_m, int& last, Track& track) {
  if (!track.empty() && frame > last + 1) track.push_back({std::nan(""), std::nan("")});
  track.push_back({x_m, z_m});
  last = frame;
}

Track CameraTrack(const RunDetail& detail, bool truth) {
  Track track;
  int last = 0;
  for (const CameraFrame& frame : detail.camera) {
    if (truth ? !frame.truth : frame.status == "skipped") continue;
    const Pose& pose = truth ? *frame.truth : frame.world_from_camera;
    AddPoint(frame.frame, pose[0], pose[2], last, track);
  }
  return track;
}

// The true track from the first frame in which the body is visible to the last.
Track TruthTrack(const BodyDetail& body) {
  Track track;
  int last = 0;
  for (const auto& [frame, pose] : body.truth) {
    if (body.visible.empty() || frame < body.visible.front() || frame > body.visible.back()) {
      continue;
    }
    AddPoint(frame, pose[0], pose[2], last, track);
  }
  return track;
}

Track EstimatedTrack(const BodyDetail& body) {
  Track track;
  int last = 0;
  for (const BodyPosition& position : body.estimated) {
    AddPoint(position.frame, position.position_m[0], position.position_m[2], last, track);
  }
  return track;
}

struct Extent {
  ValueRange x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  ValueRange z = x;

  void Add(const Track& track) {
    for (const Datum& point : track) {  // min and max ignore gaps
      x = {std::fmin(x.low, point.x), std::fmax(x.high, point.x)};
      z = {std::fmin(z.low, point.y), std::fmax(z.high, point.y)};
    }
  }
  bool IsEmpty() const { return !std::isfinite(x.high - x.low + z.high - z.low); }
  void Widen() {
    const double margin = 0.06 * std::max({x.high - x.low, z.high - z.low, 0.1});
    for (ValueRange* range : {&x, &z}) *range = {range->low - margin, range->high + margin};
  }
  bool Holds(const Track& track) const {
    return std::none_of(track.begin(), track.end(), [&](const Datum& point) {
      return point.x < x.low || point.x > x.high || point.y < z.low || point.y > z.high;
    });
  }
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
  extent.Widen();
  return extent;
}

// A track with its truth, and its name beside the start.
void AddTrack(const std::string& name, const Track& truth, const Track& estimate, const Look& look,
              Panel& panel) {
  const bool camera = name == "camera";
  panel.series.push_back({SeriesKind::kLine,
                          camera && !truth.empty() ? "truth (camera bold)" : "",
                          {0, Symbol::kNone, 0, camera ? 3.0 : 2.0},
                          truth,
                          name + ", truth"});
  panel.series.push_back({SeriesKind::kLine, "", look, estimate, StrCat(name, ", ", panel.title)});
  const Track& start = truth.empty() ? estimate : truth;
  if (start.empty()) return;
  panel.series.push_back({SeriesKind::kPoints, "start", {0, Symbol::kCircle}, {start.front()}});
  panel.notes.push_back(
      {start.front().x, start.front().y, name, false, start.back().y > start.front().y});
}

Panel RunPanel(const DrawnRun& run, const Look& look, Extent extent, bool& leaves) {
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
  const Track camera = CameraTrack(run.detail, false);
  AddTrack("camera", CameraTrack(run.detail, true), camera, look, panel);
  leaves = !extent.Holds(camera);
  for (const BodyDetail& body : run.detail.bodies) {
    if (!body.mover) continue;
    const Track estimate = EstimatedTrack(body);
    AddTrack(body.name, TruthTrack(body), estimate, look, panel);
    leaves = leaves || !extent.Holds(estimate);
  }
  return panel;
}

}  // namespace

void AddTrajectories(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMaxPanels = 9;
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    std::vector<const DrawnRun*> runs = scene.runs;
    if (runs.size() > kMaxPanels) runs.resize(kMaxPanels);
    const Extent extent = ExtentOf(runs);
    if (extent.IsEmpty()) {
      figures.not_drawn.push_back(StrCat("Trajectories on ", scene.sequence, ": no poses."));
      continue;
    }
    Chart chart;
    chart.columns = runs.size() == 1 ? 1 : runs.size() == 2 || runs.size() == 4 ? 2 : 3;
    chart.width = runs.size() == 1 ? 0.75 : 1.0;
    chart.share_x = true;
    chart.share_y = true;
    std::vector<std::string> cut;
    for (const DrawnRun* run : runs) {
      bool leaves = false;
      chart.panels.push_back(RunPanel(*run, palette.Line(run->variant), extent, leaves));
      if (leaves) cut.push_back(run->variant);
    }
    std::string caption =
        "Grey: truth, the camera in bold; coloured: the estimate. The world is that of the first "
        "left camera; both axes have one scale. Bodies are drawn where their estimate counts.";
    if (!cut.empty()) caption += StrCat(" The estimate leaves the part shown: ", Listed(cut), ".");
    if (runs.size() < scene.runs.size()) {
      caption += StrCat(" ", scene.runs.size() - runs.size(), " more variants are not shown.");
    }
    figures.figures.push_back({"trajectories-" + Slug(scene.sequence),
                               StrCat("Trajectories from above on ", scene.sequence, ", ",
                                      SeedText(scene), ". ", Capitalised(kTruthAlignment)),
                               caption, std::move(chart)});
  }
}

}  // namespace cvo::reports
