// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

// Forward flow of the left image from one frame to the next in KITTI's encoding, CV_16UC3 in
// OpenCV's order: valid (0 or 1), 64 v + 2^15, 64 u + 2^15 (red in the PNG file). A pixel whose
// surface leaves the image stays valid; one without surface, one that comes behind the camera and
// one that moves 512 px or more is not.
cv::Mat ComputeFlow(const StereoCamera& rig, const Rendering& rendering, const View& now,
                    const View& next);

}  // namespace cvo::synth
