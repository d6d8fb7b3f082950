// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/draw_overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/strokes.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

cv::Mat Background(const cv::Mat& image, const CameraInfo& camera, const CameraInfo& scaled) {
  if (image.cols != camera.width_px || image.rows != camera.height_px ||
      (image.type() != CV_8UC1 && image.type() != CV_8UC3)) {
    ThrowError("the image of a frame",
               StrCat(image.cols, "x", image.rows, " pixels of ", image.channels(), " x ",
                      8 * image.elemSize1(), " bits"),
               StrCat(camera.width_px, "x", camera.height_px,
                      " of the run's camera, grey or colour with 8 bits"));
  }
  cv::Mat sized;
  const cv::Size size(scaled.width_px, scaled.height_px);
  const bool smaller = size.width < image.cols;
  cv::resize(image, sized, size, 0.0, 0.0, smaller ? cv::INTER_AREA : cv::INTER_CUBIC);
  cv::Mat color;
  if (sized.channels() == 1) {
    cv::cvtColor(sized, color, cv::COLOR_GRAY2BGR);
  } else {
    color = sized;
  }
  return color;
}

void DrawDetections(const OverlayFrame& frame, const OverlayStyle& style, cv::Mat& image) {
  std::vector<Stroke> strokes;
  // Horizontal and vertical lines are sharp only if they are on whole pixels.
  const auto whole = [&](double pixel) { return std::round((pixel + 0.5) * style.scale - 0.5); };
  const auto scaled = [&](double u_px, double v_px) {
    return cv::Point2d(whole(u_px), whole(v_px));
  };
  for (const PixelBox& box : frame.detections) {
    const std::array<cv::Point2d, 4> corners = {
        scaled(box.left_px, box.top_px), scaled(box.right_px, box.top_px),
        scaled(box.right_px, box.bottom_px), scaled(box.left_px, box.bottom_px)};
    const bool owned = style.associations && box.cluster > 0;
    const Rgb color = owned ? ColorOf(frame, box.cluster) : kDetectionColor;
    for (std::size_t i = 0; i < 4; ++i) {
      const PixelSegment edge{corners[i], corners[(i + 1) % 4]};
      for (const PixelSegment& part : style.associations && !owned
                                          ? Dashes(edge, style.dash_px, style.dash_px)
                                          : std::vector<PixelSegment>{edge}) {
        strokes.push_back({part, color, 1});
      }
    }
  }
  constexpr double kFaintRim = 0.3;  // detections are less prominent than estimates
  DrawStrokes(strokes, kFaintRim, image);
}

// Draws outliers and static landmarks first, so that landmarks on bodies, which matter most, are on
// top.
void DrawLandmarks(const OverlayFrame& frame, const OverlayStyle& style, cv::Mat& image) {
  for (const bool on_body : {false, true}) {
    for (const LandmarkDot& dot : frame.landmarks) {
      if ((dot.label > kStaticLabel) != on_body) continue;
      if (style.wrong && dot.wrong) continue;  // drawn by DrawWrongLabels
      const cv::Point2d at((dot.u_px + 0.5) * style.scale - 0.5,
                           (dot.v_px + 0.5) * style.scale - 0.5);
      if (on_body) {
        DrawDisc(at, style.landmark_px, style.rim_px, ColorOf(frame, dot.label), image);
      } else if (dot.label == kStaticLabel) {
        DrawDisc(at, style.static_px, 0.7 * style.rim_px, kStaticColor, image);
      } else {
        DrawDisc(at, 0.5 * style.static_px, 0.0, kOutlierColor, image);
      }
    }
  }
}

// Draws each landmark with a wrong label in the colour of that label, with a ring around it.
void DrawWrongLabels(const OverlayFrame& frame, const OverlayStyle& style, cv::Mat& image) {
  constexpr Rgb kRing{255, 255, 255};
  for (const LandmarkDot& dot : frame.landmarks) {
    if (!dot.wrong) continue;
    const cv::Point2d at((dot.u_px + 0.5) * style.scale - 0.5,
                         (dot.v_px + 0.5) * style.scale - 0.5);
    const Rgb color = dot.label == kStaticLabel ? kStaticColor : ColorOf(frame, dot.label);
    DrawDisc(at, style.landmark_px + 2.6, 1.0, kRing, image);
    DrawDisc(at, style.landmark_px, 1.2, color, image);
  }
}

// Draws the inset and returns its rectangle.
cv::Rect DrawInset(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                   cv::Mat& picture) {
  constexpr double kOpacity = 0.72;
  constexpr Rgb kGround{16, 18, 24};
  const cv::Rect place = InsetRect(camera, style, style.inset_corner);
  BlendMask(cv::Mat(place.size(), CV_8UC1, cv::Scalar(255)), place.tl(), kGround, kOpacity,
            picture);
  cv::Mat inset = picture(place);
  DrawBirdsEye(frame, camera, style, inset);
  return place;
}

}  // namespace

namespace {

// Whether the status line of a crowded frame fits in one row. The answer is the same for all frames
// of a run, since all pictures of a video have one size.
bool FitInOneRow(int text_px, int width_px) {
  constexpr const char* kLong =
      "frame 0000  00.00 s  camera recovered  bodies 00 + 00 predicted (0 out of view)  landmarks "
      "0000 static, 000 on bodies, 00 outliers, 000 with a wrong label  variant, seed 0";
  return PlateSize(kLong, text_px).width <= width_px;
}

}  // namespace

OverlayStyle StyleFor(const CameraInfo& camera, int width_px) {
  OverlayStyle style;
  style.scale = static_cast<double>(width_px) / camera.width_px;
  // 1 for an image of 640x480. It is smaller for wide images, which are low.
  const double height_px = style.scale * camera.height_px;
  const double size = std::clamp(std::min(width_px / 640.0, height_px / 240.0), 0.35, 3.0);
  style.text_px = std::max(7, static_cast<int>(std::lround(6.0 + 3.0 * size)));
  style.line_px = std::max(1, static_cast<int>(std::lround(0.8 + 0.8 * size)));
  style.landmark_px = 0.5 + 1.9 * size;
  style.static_px = 0.3 + 0.7 * size;
  style.rim_px = std::min(size, 1.0);
  style.dash_px = 3.0 + 4.0 * size;
  style.names = width_px >= 400;
  style.status_rows = width_px >= 400 && !FitInOneRow(style.text_px, width_px) ? 2 : 1;
  style.inset = style.legend = width_px >= 600;
  return style;
}

cv::Rect InsetRect(const CameraInfo& scaled, const OverlayStyle& style, Corner corner) {
  const int side_px = std::min({scaled.width_px / 4, scaled.height_px / 2, 24 * style.text_px});
  const bool right = corner == Corner::kTopRight || corner == Corner::kBottomRight;
  const bool below = corner == Corner::kBottomLeft || corner == Corner::kBottomRight;
  return {right ? scaled.width_px - side_px : 0, below ? scaled.height_px - side_px : 0, side_px,
          side_px};
}

cv::Mat DrawOverlay(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                    const OverlayStyle& style) {
  const CameraInfo scaled = ScaledCamera(camera, style.scale);
  cv::Mat picture = Background(image, camera, scaled);
  if (style.boxes) FillGhosts(frame, scaled, picture);
  DrawDetections(frame, style, picture);
  if (style.boxes) DrawBoxes(frame, scaled, style, picture);
  DrawLandmarks(frame, style, picture);
  if (style.wrong) DrawWrongLabels(frame, style, picture);
  if (style.boxes) DrawMotion(frame, scaled, style, picture);
  std::vector<cv::Rect> taken;
  if (style.inset) taken.push_back(DrawInset(frame, scaled, style, picture));
  DrawNames(frame, scaled, style, taken, picture);
  std::vector<cv::Mat> parts = {picture};
  if (style.status) {
    cv::Mat bar(BarHeight(style.text_px, style.status_rows), picture.cols, CV_8UC3);
    DrawBar(StatusWords(frame, camera), style.text_px, bar);
    parts.push_back(bar);
  }
  if (style.legend) parts.push_back(LegendBar(style, picture.cols));
  std::erase_if(parts, [](const cv::Mat& part) { return part.empty(); });
  if (parts.size() == 1) return picture;
  cv::Mat all;
  cv::vconcat(parts, all);
  return all;
}

}  // namespace cvo::reports
