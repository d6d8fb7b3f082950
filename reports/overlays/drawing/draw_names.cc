// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kLongestClass = 16;

std::string NameOf(const ClusterShape& cluster, const OverlayStyle& style) {
  if (!style.names) return StrCat(cluster.id);
  const std::string category = DrawableText(cluster.category, kLongestClass);
  return StrCat(cluster.id, category.empty() ? "" : " ", category,
                cluster.predicted ? " (predicted)" : "");
}

// Returns the top left corner of a rectangle that was moved into the picture.
cv::Point Inside(cv::Point at, cv::Size size, cv::Size picture) {
  return {std::clamp(at.x, 0, std::max(0, picture.width - size.width)),
          std::clamp(at.y, 0, std::max(0, picture.height - size.height))};
}

// What a name should not cover.
struct Obstacles {
  std::vector<cv::Rect> taken;  // other names and the inset
  std::vector<cv::Rect> boxes;
  std::vector<cv::Point> dots;
};

// Candidate places of a name around its box, nearest first.
std::vector<cv::Point> PlacesAround(const cv::Rect& box, cv::Size size) {
  const int left = box.x;
  const int right = box.br().x - size.width;
  const int middle = (left + right) / 2;
  const int gap = size.height / 2;
  std::vector<cv::Point> places;
  for (const int y : {box.y - size.height, box.br().y}) {
    for (const int x : {left, right, middle}) places.emplace_back(x, y);
  }
  for (const int y : {box.y, box.y + (box.height - size.height) / 2}) {
    for (const int x : {box.x - size.width, box.br().x}) places.emplace_back(x, y);
  }
  for (const int rows : {2, 3, 4}) {
    const int away = gap + (rows - 1) * size.height;
    for (const int x : {left, right}) {
      places.emplace_back(x, box.y - size.height - away);
      places.emplace_back(x, box.br().y + away);
    }
  }
  places.push_back(box.tl());
  return places;
}

double CostOf(const cv::Rect& place, const cv::Rect& own, const Obstacles& obstacles) {
  constexpr double kOfTaken = 40.0;  // times the share of the name that it covers
  constexpr double kOfBox = 3.0;
  constexpr double kOfDot = 1.0;  // per landmark
  const double area = place.area();
  double cost = 0.0;
  for (const cv::Rect& other : obstacles.taken) cost += kOfTaken * (place & other).area() / area;
  for (const cv::Rect& box : obstacles.boxes) {
    if (box != own) cost += kOfBox * (place & box).area() / area;
  }
  for (const cv::Point& dot : obstacles.dots) cost += place.contains(dot) ? kOfDot : 0.0;
  return cost;
}

cv::Rect FreePlace(const cv::Rect& box, cv::Size size, cv::Size picture,
                   const Obstacles& obstacles) {
  constexpr double kOfPlace = 0.25;  // for each candidate that is nearer
  cv::Rect best;
  double least = std::numeric_limits<double>::infinity();
  double nearer = 0.0;
  for (const cv::Point& place : PlacesAround(box, size)) {
    const cv::Rect rect(Inside(place, size, picture), size);
    const double cost = CostOf(rect, box, obstacles) + kOfPlace * nearer++;
    if (cost >= least) continue;
    best = rect;
    least = cost;
  }
  return best;
}

Obstacles ObstaclesOf(const OverlayFrame& frame, const CameraInfo& camera,
                      const OverlayStyle& style, const std::vector<cv::Rect>& taken) {
  Obstacles obstacles{taken, {}, {}};
  for (const ClusterShape& cluster : frame.clusters) {
    if (const auto box = SeenRect(cluster, camera)) obstacles.boxes.push_back(*box);
  }
  const cv::Rect2d seen(0.0, 0.0, camera.width_px, camera.height_px);
  for (const LandmarkDot& dot : frame.landmarks) {
    const cv::Point2d at(dot.u_px * style.scale, dot.v_px * style.scale);
    if (dot.label > kStaticLabel && seen.contains(at)) obstacles.dots.emplace_back(at);
  }
  return obstacles;
}

// Appends a line from a name to its box if they are apart.
void AddLeader(const cv::Rect& place, const cv::Rect& box, Rgb color,
               std::vector<Stroke>& strokes) {
  const auto nearest = [](int low, int high, int at) { return std::clamp(at, low, high); };
  const cv::Point middle = (place.tl() + place.br()) / 2;
  const cv::Point to(nearest(box.x, box.br().x - 1, middle.x),
                     nearest(box.y, box.br().y - 1, middle.y));
  const cv::Point from(nearest(place.x, place.br().x - 1, to.x),
                       nearest(place.y, place.br().y - 1, to.y));
  if (std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) <= 2) return;
  strokes.push_back({{from, to}, color, 1});
}

}  // namespace

void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               const std::vector<cv::Rect>& taken, cv::Mat& picture) {
  Obstacles obstacles = ObstaclesOf(frame, camera, style, taken);
  std::vector<std::pair<const ClusterShape*, cv::Rect>> places;
  std::vector<Stroke> leaders;
  for (const ClusterShape& cluster : frame.clusters) {
    const auto box = SeenRect(cluster, camera);
    if (!box) continue;
    const cv::Size size = PlateSize(NameOf(cluster, style), style.text_px);
    const cv::Rect place = FreePlace(*box, size, picture.size(), obstacles);
    obstacles.taken.push_back(place);
    places.emplace_back(&cluster, place);
    AddLeader(place, *box, ColorOf(frame, cluster.id), leaders);
  }
  DrawStrokes(leaders, kRimOpacity, picture);
  for (const auto& [cluster, place] : places) {
    const Rgb color = ColorOf(frame, cluster->id);
    PlateStyle plate;
    plate.text_px = style.text_px;
    plate.fill = cluster->predicted ? Rgb{20, 20, 20} : color;
    plate.ink = TextColorOn(plate.fill);
    plate.opacity = cluster->predicted ? 0.75 : 1.0;
    if (cluster->predicted) plate.outline = color;
    DrawPlate(NameOf(*cluster, style), place.tl(), plate, picture);
  }
}

}  // namespace cvo::reports
