// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/suite/drawn_scenes.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxScenes = 6;
constexpr int kWidth_px = 720;

bool IsEstimated(const CameraFrame& frame) { return frame.calibration.has_value(); }

bool Shows(const DrawnRun& run) {
  return std::any_of(run.detail.camera.begin(), run.detail.camera.end(), IsEstimated);
}

Json LineTrace(const std::string& name, const Json& frames, Json values, Json line) {
  return {{"type", "scatter"},       {"mode", "lines"},    {"name", name},
          {"legendgroup", name},     {"x", frames},        {"y", std::move(values)},
          {"line", std::move(line)}, {"showlegend", false}};
}

// Draws the mean as a line and its standard deviation as a band.
void DrawRun(const DrawnRun& run, const Style& style, bool in_legend, std::size_t panel,
             Plot& plot) {
  Json frames = Json::array();
  Json mean = Json::array();
  Json low = Json::array();
  Json high = Json::array();
  for (const CameraFrame& frame : run.detail.camera) {
    if (!IsEstimated(frame)) continue;
    const double mean_px = frame.calibration->Mean_px();
    const double sigma_px = frame.calibration->MeanSigma_px();
    frames.push_back(frame.frame);
    mean.push_back(Rounded(mean_px));
    low.push_back(Rounded(mean_px - sigma_px));
    high.push_back(Rounded(mean_px + sigma_px));
  }
  const std::string name = PlotText(run.variant);
  plot.AddTrace(panel, LineTrace(name, frames, std::move(low), {{"width", 0}}));
  Json band = LineTrace(name, frames, std::move(high), {{"width", 0}});
  band.update({{"fill", "tonexty"}, {"fillcolor", Faded(style.colour, 0.2)}});
  plot.AddTrace(panel, std::move(band));
  Json line = LineTrace(name, frames, std::move(mean),
                        {{"color", style.colour}, {"dash", style.dash}, {"width", 1.6}});
  line["showlegend"] = in_legend;
  plot.AddTrace(panel, std::move(line));
}

// In the upper left corner, where few lines pass: estimates start near 0.
void NamePanel(const std::string& sequence, std::size_t panel, Plot& plot) {
  plot.AddAnnotation(panel, {{"text", PlotText(sequence)},
                             {"xref", "paper"},
                             {"x", 0.005},
                             {"xanchor", "left"},
                             {"y", 1},
                             {"yanchor", "top"},
                             {"font", {{"size", 11}}}});
}

std::string SceneText(const DrawnScene& scene) {
  std::string text = StrCat(Capitalised(scene.sequence), ": ");
  for (const DrawnRun* run : scene.runs) {
    const auto last =
        std::find_if(run->detail.camera.rbegin(), run->detail.camera.rend(), IsEstimated);
    text += StrCat(run == scene.runs.front() ? "" : "; ", run->variant, " ",
                   NumberText(last->calibration->Mean_px(), 2), " +- ",
                   NumberText(last->calibration->MeanSigma_px(), 2), " px in the last frame");
  }
  return text + ". ";
}

}  // namespace

void DrawCalibration(const SuiteData& data, SuiteDrawing& drawing) {
  std::vector<DrawnScene> scenes = GroupByScene(data.drawn);
  for (DrawnScene& scene : scenes) {
    std::erase_if(scene.runs, [](const DrawnRun* run) { return !Shows(*run); });
  }
  std::erase_if(scenes, [](const DrawnScene& scene) { return scene.runs.empty(); });
  if (scenes.empty()) return;
  const std::size_t drawn = std::min(scenes.size(), kMaxScenes);

  const std::vector<std::string> variants = VariantsOf(data.drawn);
  const Palette palette = PaletteOf(data.plan, variants);
  Plot plot(AxisOf("frame"), std::vector<Panel>(drawn, {AxisOf("mean (px)"), 110}),
            LegendHeight(variants, kWidth_px));
  std::vector<std::string> in_legend;
  Figure figure;
  figure.alt = "Lines of the estimated calibration error over frames, one panel per sequence. ";
  for (std::size_t i = 0; i < drawn; ++i) {
    for (const DrawnRun* run : scenes[i].runs) {
      const bool is_new =
          std::find(in_legend.begin(), in_legend.end(), run->variant) == in_legend.end();
      if (is_new) in_legend.push_back(run->variant);
      DrawRun(*run, palette.Of(run->variant), is_new, i, plot);
    }
    NamePanel(scenes[i].sequence, i, plot);
    figure.alt += SceneText(scenes[i]);
  }
  figure.alt.pop_back();
  plot.layout()["showlegend"] = true;
  figure.id = "calibration";
  figure.group = "Self-calibration";
  figure.title = "Estimated error of the stereo calibration: mean over the image";
  figure.caption =
      "How much further right points lie in the right image than in a perfect pair, as estimated "
      "after each frame. Bands: one standard deviation to each side.";
  if (scenes.size() > drawn) {
    figure.caption +=
        StrCat(" Only the first ", drawn, " of ", scenes.size(), " sequences are shown.");
  }
  figure.width_px = kWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
