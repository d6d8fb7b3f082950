// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {

// One frame of a run in four panels with their titles, each `width_px` wide: landmarks by cluster,
// boxes with tracks, bodies from above, errors of bodies over time; below them the legend. `image`
// is the left one. Throws Error as DrawOverlay and FrameOf.
cv::Mat FourPanels(const cv::Mat& image, const OverlayRun& run, int frame, int width_px);

// Position errors of the bodies of a run, each in the colour of its cluster, on a canvas of this
// size; a line marks the frame. Says so where there is no truth.
cv::Mat ErrorChart(const OverlayRun& run, int frame, int text_px, cv::Size size);

}  // namespace cvo::reports
