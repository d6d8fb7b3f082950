// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {

// Draws one frame of a run as four titled panels, each `width_px` wide: landmarks by cluster, boxes
// with tracks, bodies from above, and position errors of the bodies over time. The legend is below
// them. `image` is the left image. Throws Error for the same reasons as DrawOverlay and FrameOf.
cv::Mat FourPanels(const cv::Mat& image, const OverlayRun& run, int frame, int width_px);

// Draws the position errors of the bodies of a run over time, each in the colour of its cluster, on
// a canvas of the given size. A vertical line marks `frame`. Without ground truth, a text says so
// instead.
cv::Mat ErrorChart(const OverlayRun& run, int frame, int text_px, cv::Size size);

}  // namespace cvo::reports
