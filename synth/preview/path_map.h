// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "synth/scene/world.h"

namespace cvo::synth {

inline const cv::Scalar kInk(60, 50, 45);  // BGR, of lines and text

// Returns one colour (BGR) per body; those of consecutive bodies are easy to distinguish.
std::vector<cv::Scalar> BodyColours(std::size_t bodies);

// Draws the scene from above, with the world's x to the right and y up: the paths over frames
// [first, end) of the camera (black, with its field of view at the start) and of the bodies (in
// their colours, with their boxes at the start), a dot at the end of each path, and a scale bar.
// Fills `canvas` (CV_8UC3).
void DrawPathMap(const World& world, int first, int end, const std::vector<cv::Scalar>& colours,
                 cv::Mat canvas);

}  // namespace cvo::synth
