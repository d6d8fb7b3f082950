// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/task_pool.h"
#include "core/features/options.h"
#include "core/features/orb/corner_region.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// What is extracted of the right image: more corners than of the left one, so that each of these
// finds its partner.
OrbOptions RightOrb(const OrbOptions& orb, const StereoMatchOptions& stereo);

// Corners of the left image with their columns in the right one, sorted by (v, u, octave). Images
// are CV_8UC1 and of the camera's size: throws Error otherwise. Uses two threads of the pool; the
// result does not depend on their number. In the present frame's boxes there are also corners that
// the right image does not show.
std::vector<StereoFeature> ExtractStereoFeatures(const cv::Mat& left, const cv::Mat& right,
                                                 const StereoCamera& camera, const OrbOptions& orb,
                                                 const StereoMatchOptions& stereo, TaskPool& pool,
                                                 RecentBoxes boxes = {});

}  // namespace cvo
