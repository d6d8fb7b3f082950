// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/estimation/window.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Appends the matched features to their landmarks as observations of `frame`.
void AddObservations(const WindowFrame& frame, std::span<const StereoFeature> features,
                     const std::vector<Match>& matches, Window& window);

// Makes a landmark of each feature that is not in `matches` and has the disparity for it; ids
// follow next_id. Returns how many.
int AddLandmarks(const WindowFrame& frame, std::span<const StereoFeature> features,
                 const std::vector<Match>& matches, double min_disparity_px, LandmarkId& next_id,
                 Window& window);

// Removes landmarks that were seen once and then not in the latest `frames` frames.
void RemoveUnconfirmed(FrameId newest, int frames, Window& window);

}  // namespace cvo
