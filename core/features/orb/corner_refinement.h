// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace cvo {

// Refines a corner to sub-pixel accuracy. Returns the maximum of a paraboloid fitted to the 3 x 3
// scores around the pixel (x, y), which has the largest score, relative to that pixel. Zero if the
// paraboloid has no maximum within 1 px.
Eigen::Vector2d RefineCorner(const cv::Mat& scores, int x, int y);

}  // namespace cvo
