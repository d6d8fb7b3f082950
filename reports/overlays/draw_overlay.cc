// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/draw_overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/overlays/canvas.h"

namespace cvo::reports {
namespace {

constexpr Rgb kStatic{205, 205, 205};
constexpr Rgb kGrid{125, 128, 136};

// The camera of an image that was resized by `scale`.
CameraInfo ScaledCamera(CameraInfo camera, double scale) {
  camera.width_px = static_cast<int>(camera.width_px * scale + 0.5);
  camera.height_px = static_cast<int>(camera.height_px * scale + 0.5);
  camera.fx_px *= scale;
  camera.fy_px *= scale;
  camera.cx_px = (camera.cx_px + 0.5) * scale - 0.5;
  camera.cy_px = (camera.cy_px + 0.5) * scale - 0.5;
  return camera;
}

// Projects the part of a segment that is in front of the camera. Empty if there is none. Pixels may
// lie far outside the image.
std::optional<Segment> ProjectSegment(Eigen::Vector3d a, Eigen::Vector3d b,
                                      const CameraInfo& camera) {
  constexpr double kNear_m = 0.1;
  if (!(a.z() >= kNear_m || b.z() >= kNear_m)) return std::nullopt;
  const auto at_near = [&] {
    return Eigen::Vector3d(a + (kNear_m - a.z()) / (b.z() - a.z()) * (b - a));
  };
  if (!(a.z() >= kNear_m)) {
    a = at_near();
  } else if (!(b.z() >= kNear_m)) {
    b = at_near();
  }
  const auto pixel = [&](const Eigen::Vector3d& p) {
    return cv::Point2d(camera.fx_px * p.x() / p.z() + camera.cx_px,
                       camera.fy_px * p.y() / p.z() + camera.cy_px);
  };
  const Segment segment{pixel(a), pixel(b)};
  const bool finite = std::isfinite(segment.first.x + segment.first.y) &&
                      std::isfinite(segment.second.x + segment.second.y);
  return finite ? std::optional(segment) : std::nullopt;
}

// The twelve edges of a box, where they are in front of the camera.
std::vector<Segment> ProjectEdges(const ClusterShape& cluster, const CameraInfo& camera) {
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) != 0) continue;
      const auto edge = ProjectSegment(cluster.corners[i], cluster.corners[i | bit], camera);
      if (edge) edges.push_back(*edge);
    }
  }
  return edges;
}

// The part of the picture that a cluster's box covers. Empty if the box is out of view.
std::optional<cv::Rect> SeenRect(const ClusterShape& cluster, const CameraInfo& camera) {
  const std::vector<Segment> edges = ProjectEdges(cluster, camera);
  if (edges.empty()) return std::nullopt;
  cv::Point2d low = edges.front().first;
  cv::Point2d high = low;
  for (const auto& [a, b] : edges) {
    low = {std::min({low.x, a.x, b.x}), std::min({low.y, a.y, b.y})};
    high = {std::max({high.x, a.x, b.x}), std::max({high.y, a.y, b.y})};
  }
  const cv::Rect2d seen =
      cv::Rect2d(low, high) & cv::Rect2d(0, 0, camera.width_px, camera.height_px);
  if (!(seen.area() > 0.0)) return std::nullopt;
  return cv::Rect(seen);
}

cv::Mat Background(const cv::Mat& image, const CameraInfo& camera, const CameraInfo& scaled) {
  if (image.cols != camera.width_px || image.rows != camera.height_px ||
      (image.type() != CV_8UC1 && image.type() != CV_8UC3)) {
    ThrowError("the image of a frame",
               StrCat(image.cols, "x", image.rows, " pixels of ", image.channels(), " x ",
                      8 * image.elemSize1(), " bits"),
               StrCat(camera.width_px, "x", camera.height_px,
                      " of the run's camera, grey or colour with 8 bits"));
  }
  cv::Mat picture;
  const cv::Size size(scaled.width_px, scaled.height_px);
  const bool smaller = size.width < image.cols;
  cv::resize(image, picture, size, 0.0, 0.0, smaller ? cv::INTER_AREA : cv::INTER_CUBIC);
  if (picture.channels() == 1) cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
  return picture;
}

// Detections, and the boxes of true bodies, dashed.
void DrawImageBoxes(const OverlayFrame& frame, const OverlayStyle& style, Canvas& canvas) {
  std::vector<Stroke> strokes;
  const auto add = [&](const std::vector<ImageBox>& boxes, bool dashed) {
    for (const ImageBox& box : boxes) {
      const auto pixel = [&](double u_px, double v_px) {
        return cv::Point2d((u_px + 0.5) * style.scale - 0.5, (v_px + 0.5) * style.scale - 0.5);
      };
      const std::array corners = {pixel(box.left_px, box.top_px), pixel(box.right_px, box.top_px),
                                  pixel(box.right_px, box.bottom_px),
                                  pixel(box.left_px, box.bottom_px)};
      for (std::size_t i = 0; i < 4; ++i) {
        strokes.push_back({{corners[i], corners[(i + 1) % 4]}, kWhite, 1, dashed});
      }
    }
  };
  add(frame.detections, false);
  add(frame.truth, true);
  DrawStrokes(strokes, canvas);
}

// Landmarks on bodies, which matter most, are drawn last; wrong labels get a white ring.
void DrawLandmarks(const OverlayFrame& frame, const OverlayStyle& style, Canvas& canvas) {
  for (const bool on_body : {false, true}) {
    for (const LabelledLandmark& landmark : frame.landmarks) {
      const bool wrong = style.wrong && landmark.wrong;
      if ((landmark.label > kStaticLabel || wrong) != on_body) continue;
      const cv::Point2d at((landmark.u_px + 0.5) * style.scale - 0.5,
                           (landmark.v_px + 0.5) * style.scale - 0.5);
      const bool outlier = landmark.label == kOutlierLabel;
      const double radius_px = on_body   ? style.landmark_px
                               : outlier ? 0.5 * style.static_px
                                         : style.static_px;
      const Rgb color = landmark.label > kStaticLabel ? ClusterColor(landmark.label)
                        : outlier                     ? kWhite
                                                      : kStatic;
      if (wrong) DrawDisc(at, radius_px + 3.0, kWhite, canvas);
      if (!outlier) DrawDisc(at, radius_px + 1.0, kDark, canvas);
      DrawDisc(at, radius_px, color, canvas);
    }
  }
}

// Whether both ends are in the picture.
bool IsInView(const Segment& segment, const cv::Size& picture) {
  const cv::Rect2d view(0, 0, picture.width, picture.height);
  return view.contains(segment.first) && view.contains(segment.second);
}

// An arrow with a white core, unlike trails.
void AddArrow(const Segment& arrow, Rgb color, int width_px, std::vector<Stroke>& strokes) {
  const cv::Point2d along = arrow.second - arrow.first;
  const double length_px = std::hypot(along.x, along.y);
  if (!(length_px >= 4.0)) return;
  const cv::Point2d back = -std::min(0.4 * length_px, 5.0 * width_px) / length_px * along;
  const cv::Point2d side(-0.6 * back.y, 0.6 * back.x);
  for (const Segment& line : {arrow, Segment{arrow.second, arrow.second + back + side},
                              Segment{arrow.second, arrow.second + back - side}}) {
    strokes.push_back({line, color, width_px + 2});
  }
  for (std::size_t i = strokes.size() - 3, end = strokes.size(); i < end; ++i) {
    strokes.push_back({strokes[i].segment, kWhite, width_px});
  }
}

// Boxes, where bodies have been in view in the last two seconds, and where they go.
void DrawClusters(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  Canvas& canvas) {
  std::vector<Stroke> strokes;
  std::vector<Stroke> arrows;
  for (const ClusterShape& cluster : frame.clusters) {
    const Rgb color = ClusterColor(cluster.id);
    if (!SeenRect(cluster, camera)) continue;
    for (const Segment& edge : ProjectEdges(cluster, camera)) {
      strokes.push_back({edge, color, style.line_px, cluster.predicted});
    }
    std::vector<Segment> path;
    for (std::size_t i = 1; i < cluster.tail.size(); ++i) {
      const auto part = ProjectSegment(cluster.tail[i - 1], cluster.tail[i], camera);
      if (part && IsInView(*part, canvas.pixels.size())) path.push_back(*part);
    }
    AddTail(path, color, style.line_px, strokes);
    const auto arrow =
        cluster.next ? ProjectSegment(cluster.center(), *cluster.next, camera) : std::nullopt;
    if (arrow) AddArrow(*arrow, color, style.line_px, arrows);
  }
  DrawStrokes(strokes, canvas);
  DrawStrokes(arrows, canvas);
}

// Draws ids and classes at the top left corners of the boxes.
void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               Canvas& canvas) {
  constexpr std::size_t kLongestClass = 16;
  const int height_px = Font(style.text_px).SizeOf("X").height;
  for (const ClusterShape& cluster : frame.clusters) {
    const auto box = SeenRect(cluster, camera);
    if (!box) continue;
    std::string name = StrCat(cluster.id);
    if (style.names) name += StrCat(" ", cluster.category.substr(0, kLongestClass));
    if (style.names && cluster.predicted) name += " (predicted)";
    DrawPlate(name, box->tl() - cv::Point(0, height_px), style.text_px, ClusterColor(cluster.id),
              canvas);
  }
}

// Maps metres in the xz plane of the camera to pixels of a picture from above.
struct GroundMap {
  double range_m;  // 90 % of the height
  cv::Size picture;

  cv::Point2d operator()(double right_m, double ahead_m) const {
    const double px_per_m = 0.9 * picture.height / range_m;
    return {0.5 * picture.width + px_per_m * right_m, picture.height - 2.0 - px_per_m * ahead_m};
  }
  cv::Point2d operator()(const Eigen::Vector3d& p) const { return (*this)(p.x(), p.z()); }
};

// Draws lines at half the range and at the whole range, and the edges of the field of view.
void DrawGround(const GroundMap& map, const CameraInfo& camera, const OverlayStyle& style,
                Canvas& canvas) {
  const double range_m = map.range_m;
  std::vector<Stroke> grid;
  for (const double ahead_m : {0.5 * range_m, range_m}) {
    grid.push_back({{map(-2.0 * range_m, ahead_m), map(2.0 * range_m, ahead_m)}, kGrid});
    DrawText(FormatGeneral(ahead_m, 2) + " m", {0, static_cast<int>(map(0.0, ahead_m).y) + 1},
             Font(style.text_px), kStatic, canvas.pixels);
  }
  for (const double u_px : {0.0, 1.0 * camera.width_px}) {
    const double slope = (u_px - camera.cx_px) / camera.fx_px;
    grid.push_back({{map(0.0, 0.0), map(2.0 * slope * range_m, 2.0 * range_m)}, kGrid});
  }
  DrawStrokes(grid, canvas);
}

void DrawInset(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture) {
  const int side_px = std::min({picture.cols / 4, picture.rows / 2, 24 * style.text_px});
  cv::Mat inset = picture(cv::Rect(0, 0, side_px, side_px));
  inset.convertTo(inset, -1, 0.25, 12.0);
  DrawBirdsEye(frame, camera, style, inset);
}

// The line of text, smaller if it would not fit.
cv::Mat StatusBar(const OverlayFrame& frame, const OverlayStyle& style, int width_px) {
  cv::Mat bar(StatusHeight(style), width_px, CV_8UC3, Bgr(kDark));
  const std::string text = StatusText(frame);
  Font font(style.text_px);
  font.scale *= std::min(1.0, static_cast<double>(width_px) / font.SizeOf(text).width);
  DrawText(text, {0, (bar.rows - font.SizeOf(text).height) / 2}, font, {235, 235, 235}, bar);
  return bar;
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
  style.names = width_px >= 400;
  style.inset = width_px >= 600;
  return style;
}

namespace {

void DrawMarks(const OverlayFrame& frame, const CameraInfo& scaled, const OverlayStyle& style,
               Canvas& canvas) {
  DrawImageBoxes(frame, style, canvas);
  DrawLandmarks(frame, style, canvas);
  if (style.boxes) DrawClusters(frame, scaled, style, canvas);
  if (!style.plain) DrawNames(frame, scaled, style, canvas);
}

}  // namespace

cv::Mat DrawOverlay(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                    const OverlayStyle& style) {
  const CameraInfo scaled = ScaledCamera(camera, style.scale);
  Canvas canvas{Background(image, camera, scaled)};
  cv::Mat& picture = canvas.pixels;
  DrawMarks(frame, scaled, style, canvas);
  if (style.plain) return picture;
  if (style.inset) DrawInset(frame, scaled, style, picture);
  if (style.status) cv::vconcat(picture, StatusBar(frame, style, picture.cols), picture);
  return picture;
}

std::string OverlaySvg(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                       const OverlayStyle& style) {
  const CameraInfo scaled = ScaledCamera(camera, style.scale);
  std::string marks;
  Canvas canvas{Background(image, camera, scaled), &marks};
  DrawMarks(frame, scaled, style, canvas);
  const std::string size =
      StrCat(" width=\"", scaled.width_px, "\" height=\"", scaled.height_px, "\"");
  return StrCat("<svg xmlns=\"http://www.w3.org/2000/svg\"", size, " viewBox=\"0 0 ",
                scaled.width_px, " ", scaled.height_px, "\" font-family=\"sans-serif\" ",
                "stroke-linecap=\"round\">\n<image", size, " href=\"data:image/png;base64,",
                Base64(PngBytes(canvas.pixels)), "\"/>\n", marks, "</svg>\n");
}

void DrawBirdsEye(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  cv::Mat& picture) {
  std::vector<const ClusterShape*> seen;
  for (const ClusterShape& cluster : frame.clusters) {
    if (SeenRect(cluster, camera)) seen.push_back(&cluster);
  }
  const GroundMap map{frame.range_m, picture.size()};
  Canvas canvas{picture};
  DrawGround(map, camera, style, canvas);
  std::vector<Stroke> strokes;
  for (const ClusterShape* cluster : seen) {
    const Rgb color = ClusterColor(cluster->id);
    constexpr std::array<std::size_t, 4> kLowerFace = {2, 3, 7, 6};  // axis 1 points down
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d& a = cluster->corners[kLowerFace[i]];
      const Eigen::Vector3d& b = cluster->corners[kLowerFace[(i + 1) % 4]];
      strokes.push_back({{map(a), map(b)}, color, 1, cluster->predicted});
    }
    std::vector<Segment> path;
    for (std::size_t i = 1; i < cluster->tail.size(); ++i) {
      path.emplace_back(map(cluster->tail[i - 1]), map(cluster->tail[i]));
    }
    AddTail(path, color, style.line_px, strokes);
    if (cluster->next) {
      AddArrow({map(cluster->center()), map(*cluster->next)}, color, 1, strokes);
    }
  }
  DrawStrokes(strokes, canvas);
  for (const ClusterShape* cluster : seen) {
    const cv::Point2d center = map(cluster->center());
    DrawPlate(StrCat(cluster->id), {static_cast<int>(center.x) + 4, static_cast<int>(center.y) + 2},
              std::max(7, style.text_px - 2), ClusterColor(cluster->id), canvas);
  }
}

std::string StatusText(const OverlayFrame& frame) {
  const std::string text =
      StrCat(frame.run, "  frame ", frame.frame, "  ", FormatFixed(frame.time_s, 2), " s  ",
             frame.status, "  ", Counted(frame.clusters.size(), "body", "bodies"));
  if (frame.landmarks.empty()) return text;  // suites keep none unless they are told to
  const auto wrong = std::ranges::count(frame.landmarks, true, &LabelledLandmark::wrong);
  return StrCat(text, "  ", Counted(frame.landmarks.size(), "landmark"),
                frame.has_truth ? StrCat(", ", wrong, " wrong") : "");
}

int StatusHeight(const OverlayStyle& style) { return Font(style.text_px).SizeOf("X").height; }

}  // namespace cvo::reports
