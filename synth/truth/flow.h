// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

// Computes the forward flow of the left image from one frame to the next in KITTI's encoding,
// CV_16UC3 in OpenCV's order: valid (0 or 1), 64 v + 2^15, 64 u + 2^15 (red in the PNG file). A
// pixel stays valid if its surface point leaves the image. It is invalid if it has no surface, if
// its surface point moves behind the camera, or if the flow is 512 px or more.
cv::Mat ComputeFlow(const StereoCamera& rig, const Rendering& rendering, const View& now,
                    const View& next);

}  // namespace cvo::synth
