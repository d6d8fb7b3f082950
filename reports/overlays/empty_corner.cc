// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <opencv2/core.hpp>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {
namespace {

// How much of the bodies there is in a part of the image, over all frames: the number of their
// landmarks, plus kCovered for each frame in which a detection covers the whole part, and
// proportionally less for a fraction of it.
double BodiesIn(const cv::Rect& part, const OverlayRun& run) {
  constexpr double kCovered = 50.0;
  double sum = 0.0;
  for (const auto& [frame, dots] : run.landmarks) {
    for (const LandmarkDot& dot : dots) {
      const cv::Point at(static_cast<int>(dot.u_px), static_cast<int>(dot.v_px));
      if (dot.label > kStaticLabel && part.contains(at)) sum += 1.0;
    }
  }
  const cv::Rect2d area(part);
  for (const auto& [frame, boxes] : run.detections) {
    for (const PixelBox& box : boxes) {
      const cv::Rect2d detection(box.left_px, box.top_px, box.right_px - box.left_px,
                                 box.bottom_px - box.top_px);
      sum += kCovered * (detection & area).area() / area.area();
    }
  }
  return sum;
}

}  // namespace

Corner EmptiestCorner(const OverlayRun& run) {
  const CameraInfo& camera = run.sequence.camera;
  const OverlayStyle style = StyleFor(camera, camera.width_px);
  Corner best = Corner::kTopLeft;
  double least = BodiesIn(InsetRect(camera, style, best), run);
  for (const Corner corner : {Corner::kTopRight, Corner::kBottomLeft, Corner::kBottomRight}) {
    const double bodies = BodiesIn(InsetRect(camera, style, corner), run);
    if (bodies >= least) continue;
    least = bodies;
    best = corner;
  }
  return best;
}

void LimitTo(const std::vector<OverlayRun>& runs, OverlayStyle& style) {
  const auto any = [&](const auto& has) { return std::any_of(runs.begin(), runs.end(), has); };
  style.has_landmarks = any([](const OverlayRun& run) { return !run.landmarks.empty(); });
  style.has_detections = any([](const OverlayRun& run) {
    return std::any_of(run.detections.begin(), run.detections.end(),
                       [](const auto& boxes) { return !boxes.second.empty(); });
  });
  style.has_clusters = any([](const OverlayRun& run) { return !run.detail.clusters.empty(); });
  style.inset = style.inset && style.has_clusters;
}

}  // namespace cvo::reports
