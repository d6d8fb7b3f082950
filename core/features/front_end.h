// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/task_pool.h"
#include "core/features/options.h"
#include "core/features/orb/corner_selection.h"
#include "core/features/orb/orb.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Returns the options for the right image, in which more corners are extracted so that each left
// corner finds its partner.
OrbOptions RightOrb(const OrbOptions& orb, const StereoMatchOptions& stereo);

// Extracts the corners of the left image and their columns in the right one, sorted by (v, u,
// octave). Throws Error unless the images are CV_8UC1 and have the size of the camera. Uses two
// threads of the pool; the result does not depend on the number of threads. In the boxes of the
// current frame, corners without a match in the right image are kept as well (IsLeftOnly).
std::vector<StereoFeature> ExtractStereoFeatures(const cv::Mat& left, const cv::Mat& right,
                                                 const StereoCamera& camera, const OrbOptions& orb,
                                                 const StereoMatchOptions& stereo, TaskPool& pool,
                                                 RecentBoxes boxes = {});

}  // namespace cvo
