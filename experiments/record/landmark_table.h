// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/interface/frame.h"
#include "experiments/metrics/objects/object_matching.h"

namespace cvo {

// landmarks.csv: the landmarks observed in each frame, in the order of their features. Pixels are
// in the left image read, points in the world of the first left camera, as estimated when the frame
// was processed. Labels: 0 is the static scene, empty is none (an outlier). truth_body: 0 is the
// static scene, empty is unknown. Pixels are rounded to 0.01, metres and nats to 0.001.
extern const std::string_view kLandmarksHeader;

// Rows of one frame. `feature_truth`: one per feature, or empty.
std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth);

}  // namespace cvo
