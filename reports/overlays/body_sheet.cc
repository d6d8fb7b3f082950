// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/body_sheet.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/lists.h"
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
// Added to the id of a body without a cluster to make its label.
constexpr std::int64_t kOtherBodies = 1'000'000;

// Renders lines of text on the background of the sheet, the first one brighter.
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

// Relabels the landmarks by their true body, with the id of its cluster, so that they have its
// colour.
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

// What is known of the true place of the body in a frame.
struct TruthMark {
  std::string name;
  std::optional<PixelBox> box;
  std::optional<cv::Point2d> position_px;  // of its origin, if that is in front of the camera
};

TruthMark TruthOf(const OverlayRun& run, const BodyDetail& body, int frame,
                  const std::map<int, PixelBox>& true_boxes) {
  constexpr std::size_t kLongestName = 30;
  TruthMark mark{"truth: " + DrawableText(body.name, kLongestName), {}, {}};
  if (const auto box = true_boxes.find(frame); box != true_boxes.end()) mark.box = box->second;
  const CameraFrame* camera = FindBy(run.detail.camera, &CameraFrame::frame, frame);
  const auto* pose = FindBy(body.truth, &std::pair<int, Pose>::first, frame);
  if (camera == nullptr || pose == nullptr) return mark;
  const Position origin{pose->second[0], pose->second[1], pose->second[2]};
  mark.position_px =
      ProjectPoint(TransformBack(camera->world_from_camera, origin), run.sequence.camera);
  return mark;
}

void Include(const cv::Point2d& point, cv::Rect2d& area) {
  const cv::Rect2d spot(point.x, point.y, 1.0, 1.0);
  area = area.empty() ? spot : area | spot;
}

// The part of the image that shows the body at both its true and its estimated place, 60 % larger
// than needed, in the aspect ratio of the panels and within the image.
cv::Rect PartToShow(const OverlayRun& run, const BodyDetail& body, const OverlayFrame& frame,
                    const TruthMark& truth) {
  const CameraInfo& camera = run.sequence.camera;
  cv::Rect2d area;
  if (truth.box) {
    Include({truth.box->left_px, truth.box->top_px}, area);
    Include({truth.box->right_px, truth.box->bottom_px}, area);
  }
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

// The frame as seen by a camera whose image is this part alone, so that names stay within it.
OverlayFrame InPart(OverlayFrame frame, const cv::Rect& part) {
  const auto u = [&](double u_px) { return u_px - part.x; };
  const auto v = [&](double v_px) { return v_px - part.y; };
  std::erase_if(frame.landmarks, [&](const LandmarkDot& dot) {
    return !part.contains(cv::Point(static_cast<int>(dot.u_px), static_cast<int>(dot.v_px)));
  });
  for (LandmarkDot& dot : frame.landmarks) {
    dot.u_px -= static_cast<float>(part.x);
    dot.v_px -= static_cast<float>(part.y);
  }
  for (PixelBox& box : frame.detections) {
    box = {u(box.left_px), v(box.top_px), u(box.right_px), v(box.bottom_px), box.cluster};
  }
  return frame;
}

CameraInfo CameraOfPart(CameraInfo camera, const cv::Rect& part) {
  camera.width_px = part.width;
  camera.height_px = part.height;
  camera.cx_px -= part.x;
  camera.cy_px -= part.y;
  return camera;
}

// Marks the true place of the body: its box with heavy dashes, or a cross if only its position is
// known.
void DrawTruth(const TruthMark& truth, const cv::Rect& part, double scale, cv::Mat& panel) {
  const auto at = [&](double u_px, double v_px) {
    return cv::Point2d((u_px - part.x + 0.5) * scale - 0.5, (v_px - part.y + 0.5) * scale - 0.5);
  };
  std::vector<PixelSegment> lines;
  cv::Point2d name_at;
  if (truth.box) {
    const cv::Point2d a = at(truth.box->left_px, truth.box->top_px);
    const cv::Point2d c = at(truth.box->right_px, truth.box->bottom_px);
    lines = {{a, {c.x, a.y}}, {{c.x, a.y}, c}, {c, {a.x, c.y}}, {{a.x, c.y}, a}};
    name_at = {a.x, c.y + 2.0};
  } else if (truth.position_px) {
    constexpr double kArm_px = 9.0;
    const cv::Point2d p = at(truth.position_px->x, truth.position_px->y);
    lines = {{{p.x - kArm_px, p.y}, {p.x + kArm_px, p.y}},
             {{p.x, p.y - kArm_px}, {p.x, p.y + kArm_px}}};
    name_at = p + cv::Point2d(kArm_px, kArm_px);
  } else {
    return;
  }
  constexpr Rgb kTruth{255, 255, 255};
  std::vector<Stroke> strokes;
  for (const PixelSegment& line : lines) {
    const auto clipped = ClipSegment(line, panel.size(), 2.0);
    if (!clipped) continue;
    for (const PixelSegment& dash :
         truth.box ? Dashes(*clipped, 9.0, 6.0) : std::vector<PixelSegment>{*clipped}) {
      strokes.push_back({dash, kTruth, 2});
    }
  }
  DrawStrokes(strokes, kRimOpacity, panel);
  const cv::Size size = PlateSize(truth.name, kSheetText_px);
  const cv::Point name(
      static_cast<int>(std::clamp(name_at.x, 0.0, std::max(0.0, 1.0 * panel.cols - size.width))),
      static_cast<int>(std::clamp(name_at.y, 0.0, std::max(0.0, 1.0 * panel.rows - size.height))));
  DrawPlate(truth.name, name, {kSheetText_px, {20, 20, 20}, kTruth, 0.8, kTruth}, panel);
}

// Draws a part of a frame at panel size.
cv::Mat DrawPart(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                 const cv::Rect& part, const TruthMark& truth, bool estimated) {
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
  const cv::Mat drawn =
      DrawOverlay(image(part), InPart(frame, part), CameraOfPart(camera, part), style);
  cv::Mat panel(kPanelHeight_px, kPanelWidth_px, CV_8UC3, Bgr(kSheetGround));
  const cv::Rect there = cv::Rect({0, 0}, drawn.size()) & cv::Rect({0, 0}, panel.size());
  drawn(there).copyTo(panel(there));
  DrawTruth(truth, part, style.scale, panel);
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
                   const std::vector<std::string>& text, const std::map<int, PixelBox>& true_boxes,
                   const std::function<cv::Mat(int)>& image) {
  const CameraInfo& camera = run.sequence.camera;
  const OverlayFrame frame = FrameOf(run, event.frame);
  cv::Mat left = image(event.frame);
  if (left.empty()) left = cv::Mat::zeros(camera.height_px, camera.width_px, CV_8UC1);
  const TruthMark truth = TruthOf(run, story.body, event.frame, true_boxes);
  const cv::Rect part = PartToShow(run, story.body, frame, truth);
  cv::Mat pair(kPanelHeight_px, 2 * kPanelWidth_px + kSheetGap_px, CV_8UC3, Bgr(kSheetGround));
  DrawPart(left, ByTrueBody(run, frame), camera, part, truth, false)
      .copyTo(pair(cv::Rect(0, 0, kPanelWidth_px, kPanelHeight_px)));
  DrawPart(left, frame, camera, part, truth, true)
      .copyTo(pair(cv::Rect(kPanelWidth_px + kSheetGap_px, 0, kPanelWidth_px, kPanelHeight_px)));
  cv::Mat panel;
  cv::vconcat(TextBlock(text, pair.cols), pair, panel);
  return panel;
}

}  // namespace

cv::Mat BodySheet(const OverlayRun& run, const BodyStory& story,
                  const std::vector<std::string>& lines, const std::map<int, PixelBox>& true_boxes,
                  const std::function<cv::Mat(int)>& image) {
  const std::size_t columns = story.events.size() > 1 ? 2 : 1;
  const int event_width = 2 * kPanelWidth_px + kSheetGap_px;
  const int width = static_cast<int>(columns) * (event_width + 2 * kSheetGap_px);
  std::vector<cv::Mat> parts = {
      TextBlock(lines, width), BodyTimeline(story, width, kSheetText_px),
      TextBlock({"left: landmarks in the colour of their true body; right: as "
                 "estimated, wrong labels ringed. Boxes of detections: in the colour of the "
                 "cluster they were associated with; dashed: without a cluster.",
                 "White with heavy dashes, or a cross if no box is known: the true body"},
                width)};
  const auto texts = EventTexts(run, story);
  for (std::size_t i = 0; i < story.events.size(); i += columns) {
    cv::Mat row;
    for (std::size_t k = i; k < i + columns; ++k) {
      const cv::Mat panel = k < story.events.size() ? EventPanel(run, story, story.events[k],
                                                                 texts[k], true_boxes, image)
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
