// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace cvo {

// Where the score has its maximum, relative to the pixel (x, y) with the largest: that of a
// paraboloid through the 3 x 3 scores around it. Zero where this is no maximum within 1 px.
Eigen::Vector2d RefineCorner(const cv::Mat& scores, int x, int y);

}  // namespace cvo
