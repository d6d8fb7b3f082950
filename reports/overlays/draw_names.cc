// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "reports/overlays/draw_cluster.h"
#include "reports/overlays/text_plate.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kLongestClass = 16;

std::string NameOf(const ClusterShape& cluster, const OverlayStyle& style) {
  if (!style.names) return StrCat(cluster.id);
  const std::string category = DrawableText(cluster.category, kLongestClass);
  return StrCat(cluster.id, category.empty() ? "" : " ", category,
                cluster.predicted ? " (predicted)" : "");
}

// Moves a rectangle into the picture.
cv::Point Inside(cv::Point at, cv::Size size, cv::Size picture) {
  return {std::clamp(at.x, 0, std::max(0, picture.width - size.width)),
          std::clamp(at.y, 0, std::max(0, picture.height - size.height))};
}

// Above the box, below it, or within, whichever covers least of the names that stand already.
cv::Rect FreePlace(const cv::Rect& box, cv::Size size, cv::Size picture,
                   const std::vector<cv::Rect>& taken) {
  const int right = box.br().x - size.width;
  const std::array<cv::Point, 6> places = {{{box.x, box.y - size.height},
                                            {right, box.y - size.height},
                                            {box.x, box.br().y},
                                            {right, box.br().y},
                                            {box.x, box.y},
                                            {box.x, box.y - 2 * size.height}}};
  cv::Rect best;
  int least = -1;
  for (const cv::Point& place : places) {
    const cv::Rect rect(Inside(place, size, picture), size);
    int covered = 0;
    for (const cv::Rect& other : taken) covered += (rect & other).area();
    if (least >= 0 && covered >= least) continue;
    best = rect;
    least = covered;
  }
  return best;
}

}  // namespace

void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture) {
  std::vector<cv::Rect> taken;
  for (const ClusterShape& cluster : frame.clusters) {
    const auto box = SeenRect(cluster, camera);
    if (!box) continue;
    const std::string name = NameOf(cluster, style);
    const cv::Rect place = FreePlace(*box, PlateSize(name, style.text_px), picture.size(), taken);
    taken.push_back(place);
    const Rgb color = ColorOf(frame, cluster.id);
    PlateStyle plate;
    plate.text_px = style.text_px;
    plate.fill = cluster.predicted ? Rgb{20, 20, 20} : color;
    plate.ink = TextColorOn(plate.fill);
    plate.opacity = cluster.predicted ? 0.75 : 1.0;
    if (cluster.predicted) plate.outline = color;
    DrawPlate(name, place.tl(), plate, picture);
  }
}

}  // namespace cvo::reports
