// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/scene_check/image_shift.h"

namespace cvo {

// What a left image's pixels show: depth in m (CV_32FC1) and body (CV_16UC1).
struct Surface {
  cv::Mat depth;
  cv::Mat instances;
};

// A pixel's point in the left camera; its depth must be positive.
Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v);

// Whether all pixels around (u, v) show one smooth piece of one body.
bool IsSmooth(const StereoCamera& camera, const Surface& surface, int u, int v);

// Where pixels of the left image, every `step`-th of every `step`-th row, are in the right one.
// Pixels at edges of depth and those hidden from the right camera are left out.
std::vector<PixelPrediction> PredictRight(const StereoCamera& camera, const Surface& surface,
                                          int step);

// The same from one frame to another for the pixels of one body (0: background), which moved by
// next_from_this from the one left camera to the other. `depth_errors_px` gets, per prediction, how
// far the depth there is from the moved one, as a disparity.
std::vector<PixelPrediction> PredictNext(const StereoCamera& camera, const Surface& surface,
                                         const Surface& next, int body,
                                         const RigidTransform& next_from_this, int step,
                                         std::vector<float>& depth_errors_px);

}  // namespace cvo
