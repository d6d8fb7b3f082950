// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/scene_check/image_shift.h"

namespace cvo {

// What the pixels of a left image show: depth in m (CV_32FC1) and body id (CV_16UC1).
struct Surface {
  cv::Mat depth;
  cv::Mat instances;
};

// Returns the point at a pixel, in the left camera. The pixel's depth must be positive.
Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v);

// Whether (u, v) and its eight neighbours show one smooth surface of one body.
bool IsSmooth(const StereoCamera& camera, const Surface& surface, int u, int v);

// Predicts the positions in the right image of pixels of the left one, taking every `step`-th pixel
// of every `step`-th row. Leaves out pixels at depth edges and those hidden from the right camera.
std::vector<PixelPrediction> PredictRight(const StereoCamera& camera, const Surface& surface,
                                          int step);

// Predicts the positions in the next frame of the pixels of one body (0: background), which moves
// by next_from_this from the one left camera to the other. Appends to `depth_errors_px`, for each
// prediction, the absolute difference between predicted and actual depth, as a disparity.
std::vector<PixelPrediction> PredictNext(const StereoCamera& camera, const Surface& surface,
                                         const Surface& next, int body,
                                         const RigidTransform& next_from_this, int step,
                                         std::vector<float>& depth_errors_px);

}  // namespace cvo
