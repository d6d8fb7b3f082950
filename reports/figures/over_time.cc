// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr Symbol kBirth = Symbol::kOpenTriangle;
constexpr Symbol kSwitch = Symbol::kCross;
constexpr int kDotted = 4;

// A series without data, for the legend.
Series LegendOnly(SeriesKind kind, const std::string& name, const Look& look) {
  return {kind, name, look, {}};
}

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
  constexpr std::size_t kMaxBodies = 6;
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

// The errors over frames, with gaps where frames are missing.
std::vector<Datum> ErrorsOf(const std::vector<BodyPosition>& positions, const ErrorScale& scale) {
  std::vector<Datum> data;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0 && positions[i].frame > positions[i - 1].frame + 1) data.push_back({kGap, kGap});
    data.push_back({static_cast<double>(positions[i].frame), scale.Shown(positions[i].error_m)});
  }
  return data;
}

// A mark at a frame, at the height of the error in that frame or in the nearest one that has one.
Datum MarkAt(int frame, const BodyDetail& body, const ErrorScale& scale) {
  Datum mark{static_cast<double>(frame), kGap};
  int nearest = std::numeric_limits<int>::max();
  for (const auto* positions : {&body.estimated, &body.predicted}) {
    for (const BodyPosition& position : *positions) {
      const int distance = std::abs(position.frame - frame);
      if (distance >= nearest) continue;
      mark.y = scale.Shown(position.error_m);
      nearest = distance;
    }
  }
  return mark;
}

std::string ErrorText(const std::string& variant, const BodyDetail& body, const ErrorScale& scale) {
  if (body.estimated.empty()) return variant;
  double most = 0.0;
  for (const BodyPosition& position : body.estimated) most = std::max(most, position.error_m);
  const double rmse = RootMeanSquare(body.estimated, &BodyPosition::error_m).value();
  std::string text = StrCat(variant, ": ", NumberText(scale.from_m * rmse, 2), " ", scale.unit,
                            " root mean square, at most ", NumberText(scale.from_m * most, 2),
                            ", in ", body.estimated.size(), " frames");
  if (!body.predicted.empty()) text += StrCat(" and ", body.predicted.size(), " predicted");
  return text;
}

// Adds what one run estimates of a body.
void AddRun(const DrawnRun& run, const BodyDetail& body, const ErrorScale& scale, Look look,
            Panel& panel) {
  const std::string text = ErrorText(run.variant, body, scale);
  const std::string name = body.estimated.empty() ? "" : run.variant;
  panel.series.push_back({SeriesKind::kLine, name, look, ErrorsOf(body.estimated, scale), text});
  look.dash = kDotted;
  if (!body.predicted.empty()) {
    panel.series.push_back({SeriesKind::kLine, "", look, ErrorsOf(body.predicted, scale),
                            run.variant + ", predicted"});
  }
  const auto mark = [&](int frame, Symbol symbol, const std::string& what) {
    look.symbol = symbol;
    Datum datum = MarkAt(frame, body, scale);
    datum.tip = StrCat(run.variant, ": ", what, " in frame ", frame);
    panel.series.push_back({SeriesKind::kPoints, "", look, {std::move(datum)}});
  };
  const ClusterRow* birth = FindBy(run.detail.clusters, &ClusterRow::id, body.cluster);
  if (birth != nullptr) mark(birth->frame, kBirth, "cluster begins");
  if (!run.switches) return;
  for (const IdentitySwitch& change : *run.switches) {
    if (change.body == body.id) mark(change.frame, kSwitch, "identity switch");
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

// Adds to the legend what the panels contain beside the lines of the runs.
void AddLegend(Chart& chart) {
  std::vector<Series> legend;
  const auto add = [&](SeriesKind kind, const std::string& name, const Look& like) {
    for (const Panel& panel : chart.panels) {
      for (const Series& series : panel.series) {
        const bool same = series.look.symbol == like.symbol &&
                          (like.symbol != Symbol::kNone || series.look.dash == like.dash);
        if (!same || series.data.empty()) continue;
        legend.push_back(LegendOnly(kind, name, like));
        return;
      }
    }
  };
  add(SeriesKind::kLine, "predicted", {0, Symbol::kNone, kDotted});
  add(SeriesKind::kPoints, "cluster begins", {0, kBirth});
  add(SeriesKind::kPoints, "identity switch", {0, kSwitch});
  std::vector<Series>& last = chart.panels.back().series;
  last.insert(last.end(), legend.begin(), legend.end());
}

std::string Caption(const DrawnScene& scene, const SceneBodies& bodies, const ErrorScale& scale,
                    const Chart& chart) {
  std::string text = "Dotted: predicted by the motion model alone. Gaps: no estimate that counts.";
  if (std::any_of(chart.panels.begin(), chart.panels.end(),
                  [](const Panel& panel) { return !panel.shades.empty(); })) {
    text += " Shaded: the body is not visible: hidden, too small or out of the image.";
  }
  if (scale.log) text += " The scale of errors is logarithmic.";
  std::vector<std::string> silent;
  std::vector<std::string> unknown;
  for (const DrawnRun* run : scene.runs) {
    if (std::none_of(bodies.drawn.begin(), bodies.drawn.end(), [&](const BodyDetail* drawn) {
          const BodyDetail* body = FindBody(*run, drawn->id);
          return body != nullptr && !(body->estimated.empty() && body->predicted.empty());
        })) {
      silent.push_back(run->variant);
    }
    if (!run->switches) unknown.push_back(run->variant);
  }
  const auto list = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) text += StrCat(" ", what, ": ", Listed(names), ".");
  };
  list("Without an estimate of these bodies", silent);
  list("Identity switches not known, no landmarks.csv", unknown);
  list("Estimated by none", bodies.never);
  if (bodies.left_out > 0) {
    text += StrCat(" ", bodies.left_out, " bodies that are visible in fewer frames are not shown.");
  }
  return text;
}

Figure SceneFigure(const DrawnScene& scene, const SceneBodies& bodies, const Palette& palette) {
  const ErrorScale scale = ScaleOf(scene, bodies);
  Chart chart;
  chart.share_x = true;
  for (const BodyDetail* drawn : bodies.drawn) {
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
  AddLegend(chart);
  const std::string caption = Caption(scene, bodies, scale, chart);
  return {"error-over-time-" + Slug(scene.sequence),
          StrCat("Position error of moving bodies on ", scene.sequence, ", ", SeedText(scene),
                 ". Per frame, ", kTruthAlignment),
          caption, std::move(chart)};
}

// A frame in the spatial track, from the frame that moved it there to the last frame for which it
// was in the window.
struct SpatialStay {
  int first = 0;
  int last = 0;
};

std::map<int, SpatialStay> SpatialStays(const std::vector<CameraFrame>& frames) {
  std::map<int, SpatialStay> stays;  // by frame
  for (const CameraFrame& newest : frames) {
    for (const int age : newest.spatial_ages) {
      stays.try_emplace(newest.frame - age, SpatialStay{newest.frame, 0}).first->second.last =
          newest.frame;
    }
  }
  return stays;
}

// The oldest frame of the temporal track, which contains no frames without a pose.
int TemporalTail(const std::vector<CameraFrame>& frames, std::size_t newest) {
  int left = frames[newest].window_frames - static_cast<int>(frames[newest].spatial_ages.size());
  std::size_t tail = newest;
  for (std::size_t i = newest + 1; i-- > 0 && left > 0;) {
    if (frames[i].window_frames == 0) continue;
    tail = i;
    --left;
  }
  return frames[tail].frame;
}

// The mean as a line and its standard deviation as a band.
void AddCalibrationOf(const DrawnRun& run, const Look& look, Panel& panel) {
  Series line{SeriesKind::kLine, run.variant, look, {}};
  for (const CameraFrame& frame : run.detail.camera) {
    if (!frame.calibration) continue;
    Datum datum{static_cast<double>(frame.frame), frame.calibration->Mean_px()};
    const double sigma_px = frame.calibration->MeanSigma_px();
    datum.y_interval = {datum.y - sigma_px, datum.y + sigma_px};
    line.tip = StrCat(run.variant, ": ", NumberText(datum.y, 2), " ± ", NumberText(sigma_px, 2),
                      " px in the last frame");
    line.data.push_back(std::move(datum));
  }
  if (line.data.empty()) return;
  Series band = line;
  band.kind = SeriesKind::kBand;
  band.name.clear();
  band.look.opacity = 0.18;
  panel.series.push_back(std::move(band));
  panel.series.push_back(std::move(line));
}

}  // namespace

void AddErrorOverTime(const SuiteData& data, SuiteFigures& figures) {
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    const SceneBodies bodies = ChooseBodies(scene);
    if (bodies.drawn.empty()) {
      figures.not_drawn.push_back(
          StrCat("Error over time on ", scene.sequence,
                 ": no moving body with truth is estimated in the runs read."));
      continue;
    }
    figures.figures.push_back(SceneFigure(scene, bodies, palette));
  }
}

void AddFrameTracks(const SuiteData& data, SuiteFigures& figures) {
  for (const DrawnRun& run : data.drawn) {
    const std::vector<CameraFrame>& frames = run.detail.camera;
    const std::map<int, SpatialStay> stays = SpatialStays(frames);
    if (stays.empty()) continue;
    Series temporal{SeriesKind::kBand, "temporal track", {3, Symbol::kNone, 0, 1.0, 0.5}, {}};
    Series spatial{SeriesKind::kLine, "spatial track", {2}, {}};
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (frames[i].window_frames == 0) continue;
      const double newest = frames[i].frame;
      Datum datum{newest, newest};
      datum.y_interval = {static_cast<double>(TemporalTail(frames, i)), newest};
      temporal.data.push_back(std::move(datum));
    }
    for (const auto& [frame, stay] : stays) {
      const auto at = static_cast<double>(frame);
      spatial.data.push_back({static_cast<double>(stay.first), at});
      spatial.data.push_back({static_cast<double>(stay.last), at});
      spatial.data.push_back({kGap, kGap});
    }
    Panel panel;
    panel.x.title = "newest frame";
    panel.y.title = "frame in the window";
    panel.aspect = 0.5;
    panel.series = {std::move(temporal), std::move(spatial)};
    Chart chart;
    chart.panels = {std::move(panel)};
    figures.figures.push_back(
        {"frame-tracks",
         StrCat("Frames in the window: ", run.sequence, ", ", run.variant, ", seed ", run.seed),
         "What the window holds when a frame has been processed, from bottom to top: each frame of "
         "the spatial track is a line from the frame that moved it there to the last one before it "
         "was marginalised; the band is the temporal track, the newest frames.",
         std::move(chart)});
    return;
  }
}

void AddCalibration(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMaxScenes = 6;
  const Palette palette = PaletteOf(data.plan, VariantsOf(data.drawn));
  Chart chart;
  chart.share_x = true;
  std::size_t scenes = 0;
  for (const DrawnScene& scene : GroupByScene(data.drawn)) {
    Panel panel;
    panel.title = scene.sequence;
    panel.x.title = "frame";
    panel.y.title = "mean (px)";
    panel.aspect = 0.17;
    for (const DrawnRun* run : scene.runs) {
      AddCalibrationOf(*run, palette.Line(run->variant), panel);
    }
    if (!panel.series.empty() && ++scenes <= kMaxScenes) chart.panels.push_back(std::move(panel));
  }
  if (scenes == 0) return;
  std::string caption =
      "How much further right points lie in the right image than in a perfect pair, as estimated "
      "after each frame. Bands: one standard deviation to each side.";
  if (scenes > kMaxScenes) {
    caption += StrCat(" Only the first ", kMaxScenes, " of ", scenes, " sequences are shown.");
  }
  figures.figures.push_back({"calibration",
                             "Estimated error of the stereo calibration: mean over the image",
                             caption, std::move(chart)});
}

}  // namespace cvo::reports
