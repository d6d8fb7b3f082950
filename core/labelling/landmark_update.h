// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/labelling/cluster_labels.h"

namespace cvo {

// What UpdateLandmarks reads.
struct LandmarkUpdateOptions {
  FeatureNoise noise;
  bool align_patches = true;  // tracking.align_patches
};

// Every landmark that the frame `entering` sees gets its observation and its label. A landmark
// whose label changes goes to its new body with the observations that agree with that body's
// motion; a feature without landmark becomes one (ids from next_id on). A cluster that has no pose
// in the frame takes nothing in. The labels get the landmarks' ids. Returns the number of new ones.
int UpdateLandmarks(const FrameView& view, const LandmarkUpdateOptions& options,
                    const WindowFrame& entering, const std::vector<ClusterTrack>& tracks,
                    const std::vector<FramePoint>& points, FrameLabels& labels, LandmarkId& next_id,
                    Window& window, ClusterMap& map);

// Removes landmarks that were seen once and then not in the latest `frames` frames.
void RemoveUnconfirmed(FrameId newest, int frames, std::vector<Landmark>& landmarks);

}  // namespace cvo
