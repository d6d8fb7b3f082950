// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/body_sheet.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/project.h"
#include "reports/overlays/drawing/text_plate.h"
#include "reports/runs/body_words.h"

namespace cvo::reports {
namespace {

constexpr int kPanelWidth_px = 440;
constexpr int kPanelHeight_px = 330;
constexpr int kSheetGap_px = 8;
constexpr int kSheetText_px = 9;
constexpr Rgb kSheetGround{16, 18, 24};
constexpr Rgb kSheetInk{215, 217, 222};
constexpr std::int64_t kOtherBodies = 1'000'000;  // labels of bodies without a cluster

// Lines of text on the sheet's ground, the first brighter.
cv::Mat TextBlock(const std::vector<std::string>& lines, int width_px) {
  constexpr std::size_t kLongest = 200;
  const int step = PlateSize("Xg", kSheetText_px).height + 2;
  cv::Mat block(step * static_cast<int>(lines.size()) + 4, width_px, CV_8UC3, Bgr(kSheetGround));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PlateStyle style{kSheetText_px, kSheetGround, i == 0 ? Rgb{255, 255, 255} : kSheetInk};
    DrawPlate(DrawableText(lines[i], kLongest), {0, 2 + step * static_cast<int>(i)}, style, block);
  }
  return block;
}

// Landmarks with their true body as label: the id of its cluster, whose colour it has.
OverlayFrame ByTrueBody(const OverlayRun& run, OverlayFrame frame) {
  std::map<int, std::int64_t> labels;
  for (const BodyDetail& body : run.detail.bodies) {
    labels[body.id] = body.cluster > 0 ? body.cluster : kOtherBodies + body.id;
  }
  for (LandmarkDot& dot : frame.landmarks) {
    const auto label = labels.find(dot.truth_body);
    dot.label = label != labels.end() ? label->second
                : dot.truth_body == 0 ? kStaticLabel
                                      : kOutlierLabel;
  }
  frame.clusters.clear();
  return frame;
}

void Include(const cv::Point2d& point, cv::Rect2d& area) {
  const cv::Rect2d spot(point.x, point.y, 1.0, 1.0);
  area = area.empty() ? spot : area | spot;
}

// What shows the body where it is and where it is thought to be, with as much again around it, in
// the panels' shape and within the image.
cv::Rect PartToShow(const OverlayRun& run, const BodyDetail& body, const OverlayFrame& frame) {
  const CameraInfo& camera = run.sequence.camera;
  cv::Rect2d area;
  for (const LandmarkDot& dot : frame.landmarks) {
    if (dot.truth_body == body.id) Include({dot.u_px, dot.v_px}, area);
  }
  for (const ClusterShape& cluster : frame.clusters) {
    const std::optional<cv::Rect> seen = SeenRect(cluster, camera);
    if (cluster.id != body.cluster || !seen) continue;
    Include(seen->tl(), area);
    Include(seen->br(), area);
  }
  if (area.empty()) area = {0.0, 0.0, 1.0 * camera.width_px, 1.0 * camera.height_px};
  constexpr double kLeastWidth_px = 160.0;
  constexpr double kShape = 1.0 * kPanelWidth_px / kPanelHeight_px;
  double width = std::max({kLeastWidth_px, 1.6 * area.width, 1.6 * kShape * area.height});
  width = std::min({width, 1.0 * camera.width_px, kShape * camera.height_px});
  const cv::Size2d size(width, width / kShape);
  const cv::Point2d center = 0.5 * (area.tl() + area.br());
  const double left = std::clamp(center.x - size.width / 2, 0.0, camera.width_px - size.width);
  const double top = std::clamp(center.y - size.height / 2, 0.0, camera.height_px - size.height);
  return {static_cast<int>(left), static_cast<int>(top), static_cast<int>(size.width),
          static_cast<int>(size.height)};
}

// The part of a drawing at panel size.
cv::Mat DrawPart(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                 const cv::Rect& part, bool estimated) {
  OverlayStyle style = StyleFor(camera, 640);
  style.text_px = kSheetText_px;
  style.landmark_px = 2.6;
  style.static_px = 1.4;
  style.line_px = 2;
  style.scale = 1.0 * kPanelWidth_px / part.width;
  style.status = style.inset = style.legend = false;
  style.associations = true;
  style.names = true;
  style.wrong = estimated;
  const cv::Mat all = DrawOverlay(image, frame, camera, style);
  const cv::Rect cut(static_cast<int>(part.x * style.scale), static_cast<int>(part.y * style.scale),
                     kPanelWidth_px, kPanelHeight_px);
  cv::Mat panel(kPanelHeight_px, kPanelWidth_px, CV_8UC3, Bgr(kSheetGround));
  const cv::Rect there = cut & cv::Rect({0, 0}, all.size());
  all(there).copyTo(panel(cv::Rect({0, 0}, there.size())));
  return panel;
}

std::vector<std::vector<std::string>> EventTexts(const OverlayRun& run, const BodyStory& story) {
  std::vector<std::vector<std::string>> texts;
  std::size_t rows = 0;
  for (const BodyEvent& event : story.events) {
    texts.push_back(FrameLines(story, FrameOf(story, event.frame), run.detail.bodies));
    texts.back().insert(texts.back().begin(),
                        StrCat("(", texts.size(), ") frame ", event.frame, ": ", event.what));
    rows = std::max(rows, texts.back().size());
  }
  for (auto& text : texts) text.resize(rows);
  return texts;
}

cv::Mat EventPanel(const OverlayRun& run, const BodyStory& story, const BodyEvent& event,
                   const std::vector<std::string>& text, const std::function<cv::Mat(int)>& image) {
  const CameraInfo& camera = run.sequence.camera;
  const OverlayFrame frame = FrameOf(run, event.frame);
  cv::Mat left = image(event.frame);
  if (left.empty()) left = cv::Mat::zeros(camera.height_px, camera.width_px, CV_8UC1);
  const cv::Rect part = PartToShow(run, story.body, frame);
  cv::Mat pair(kPanelHeight_px, 2 * kPanelWidth_px + kSheetGap_px, CV_8UC3, Bgr(kSheetGround));
  DrawPart(left, ByTrueBody(run, frame), camera, part, false)
      .copyTo(pair(cv::Rect(0, 0, kPanelWidth_px, kPanelHeight_px)));
  DrawPart(left, frame, camera, part, true)
      .copyTo(pair(cv::Rect(kPanelWidth_px + kSheetGap_px, 0, kPanelWidth_px, kPanelHeight_px)));
  cv::Mat panel;
  cv::vconcat(TextBlock(text, pair.cols), pair, panel);
  return panel;
}

}  // namespace

cv::Mat BodySheet(const OverlayRun& run, const BodyStory& story,
                  const std::vector<std::string>& lines, const std::function<cv::Mat(int)>& image) {
  const std::size_t columns = story.events.size() > 1 ? 2 : 1;
  const int event_width = 2 * kPanelWidth_px + kSheetGap_px;
  const int width = static_cast<int>(columns) * (event_width + 2 * kSheetGap_px);
  std::vector<cv::Mat> parts = {
      TextBlock(lines, width), BodyTimeline(story, width, kSheetText_px),
      TextBlock({"left: landmarks in the colour of their true body; right: as "
                 "estimated, wrong labels ringed. Boxes of detections: in "
                 "the colour of the cluster they were associated with; "
                 "dashed: with none"},
                width)};
  const auto texts = EventTexts(run, story);
  for (std::size_t i = 0; i < story.events.size(); i += columns) {
    cv::Mat row;
    for (std::size_t k = i; k < i + columns; ++k) {
      const cv::Mat panel = k < story.events.size()
                                ? EventPanel(run, story, story.events[k], texts[k], image)
                                : cv::Mat();
      if (row.empty()) {
        row = cv::Mat(panel.rows + 2 * kSheetGap_px, width, CV_8UC3, Bgr(kSheetGround));
      }
      if (panel.empty()) continue;
      const int x = static_cast<int>(k - i) * (event_width + 2 * kSheetGap_px) + kSheetGap_px;
      panel.copyTo(row(cv::Rect({x, kSheetGap_px}, panel.size())));
    }
    parts.push_back(row);
  }
  cv::Mat sheet;
  cv::vconcat(parts, sheet);
  return sheet;
}

}  // namespace cvo::reports
