// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr int kTracksWidth_px = 720;

// A frame in the spatial track, from the frame that moved it there to the last frame for which it
// was in the window.
struct SpatialStay {
  int frame = 0;
  int first = 0;
  int last = 0;
};

std::vector<SpatialStay> SpatialStays(const std::vector<CameraFrame>& frames) {
  std::map<int, SpatialStay> stays;
  for (const CameraFrame& newest : frames) {
    for (const int age : newest.spatial_ages) {
      const int frame = newest.frame - age;
      stays.try_emplace(frame, SpatialStay{frame, newest.frame, newest.frame}).first->second.last =
          newest.frame;
    }
  }
  std::vector<SpatialStay> all;
  for (const auto& [frame, stay] : stays) all.push_back(stay);
  return all;
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

Json TrackTrace(const char* name, const char* colour, Json x, Json y) {
  return {{"type", "scatter"}, {"mode", "lines"},
          {"name", name},      {"line", {{"color", colour}, {"width", 2}}},
          {"x", std::move(x)}, {"y", std::move(y)}};
}

void AddTemporal(const std::vector<CameraFrame>& frames, Plot& plot) {
  Json x = Json::array();
  Json newest = Json::array();
  Json tails = Json::array();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].window_frames == 0) continue;
    x.push_back(frames[i].frame);
    newest.push_back(frames[i].frame);
    tails.push_back(TemporalTail(frames, i));
  }
  Json lower = TrackTrace("", "#009e73", x, std::move(tails));
  lower["showlegend"] = false;
  Json upper = TrackTrace("temporal track", "#009e73", std::move(x), std::move(newest));
  upper["fill"] = "tonexty";
  plot.AddTrace(0, std::move(lower));
  plot.AddTrace(0, std::move(upper));
}

void AddSpatial(const std::vector<SpatialStay>& stays, Plot& plot) {
  Json x = Json::array();
  Json y = Json::array();
  for (const SpatialStay& stay : stays) {
    for (const Json& at : {Json(stay.first), Json(stay.last), Json(nullptr)}) x.push_back(at);
    for (const Json& at : {Json(stay.frame), Json(stay.frame), Json(nullptr)}) y.push_back(at);
  }
  Json trace = TrackTrace("spatial track", "#d55e00", std::move(x), std::move(y));
  trace.update({{"mode", "lines+markers"}, {"marker", {{"size", 3}}}, {"connectgaps", false}});
  plot.AddTrace(0, std::move(trace));
}

double MeanStay(const std::vector<SpatialStay>& stays) {
  double sum = 0.0;
  for (const SpatialStay& stay : stays) sum += stay.last - stay.first + 1;
  return sum / static_cast<double>(stays.size());
}

}  // namespace

void DrawFrameTracks(const SuiteData& data, SuiteDrawing& drawing) {
  const auto drawn = std::find_if(data.drawn.begin(), data.drawn.end(), [](const DrawnRun& run) {
    return !SpatialStays(run.detail.camera).empty();
  });
  if (drawn == data.drawn.end()) return;
  const std::vector<CameraFrame>& frames = drawn->detail.camera;
  const std::vector<SpatialStay> stays = SpatialStays(frames);
  Plot plot(AxisOf("newest frame"), {{AxisOf("frame in the window"), 300}},
            LegendHeight({"temporal track", "spatial track"}, kTracksWidth_px));
  AddTemporal(frames, plot);
  AddSpatial(stays, plot);
  plot.layout()["showlegend"] = true;
  Figure figure;
  figure.id = "frame-tracks";
  figure.group = "Frame management";
  figure.title = StrCat("Frames in the window: ", drawn->sequence, ", ", drawn->variant, ", seed ",
                        drawn->seed);
  figure.caption =
      "What the window holds when a frame has been processed, from bottom to top: each frame of "
      "the "
      "spatial track is a line from the frame that moved it there to the last one before it was "
      "marginalised; the band is the temporal track, the newest frames.";
  figure.alt =
      StrCat("Of ", frames.size(), " frames ", stays.size(), " moved to the spatial track, for ",
             NumberText(MeanStay(stays)), " frames on average.");
  figure.width_px = kTracksWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
