// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/panels.h"

#include <opencv2/core.hpp>

#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/text_plate.h"
#include "reports/overlays/sheet.h"

namespace cvo::reports {
namespace {

constexpr Rgb kMapGround{16, 18, 24};

}  // namespace

cv::Mat FourPanels(const cv::Mat& image, const OverlayRun& run, int frame, int width_px) {
  const CameraInfo& camera = run.sequence.camera;
  OverlayStyle style = StyleFor(camera, width_px);
  style.status = style.inset = style.legend = false;
  style.names = true;
  const OverlayFrame all = FrameOf(run, frame);
  OverlayFrame landmarks = all;
  landmarks.clusters.clear();
  landmarks.detections.clear();
  OverlayFrame boxes = all;
  boxes.landmarks.clear();
  const cv::Mat first = DrawOverlay(image, landmarks, camera, style);
  cv::Mat map(first.size(), CV_8UC3, Bgr(kMapGround));
  DrawBirdsEye(all, ScaledCamera(camera, style.scale), style, map);
  const cv::Mat grid = Panels(
      {{"landmarks by body", first},
       {"boxes and tracks", DrawOverlay(image, boxes, camera, style)},
       {"from above", map},
       {"position error of bodies over time", ErrorChart(run, frame, style.text_px, first.size())}},
      style.text_px, 2);
  cv::Mat both;
  cv::vconcat(grid, LegendBar(style, grid.cols), both);
  return both;
}

}  // namespace cvo::reports
