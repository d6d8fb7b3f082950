// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>

#include "synth/write/clean_render.h"

namespace cvo::synth {

// Returns a contact sheet, CV_8UC3 (BGR): eleven frames spread over the scene's frames [first,
// end), as left images in colour with tinted masks, visible boxes (solid), amodal boxes (dashed)
// and names, and a map of the paths of the camera and the bodies from above. Throws Stopped.
cv::Mat MakeContactSheet(const World& world, int first, int end, const DrawingTools& tools,
                         const WorkHooks& hooks);

}  // namespace cvo::synth
