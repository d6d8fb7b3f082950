// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/kitti_ap/average_precision.h"
#include "experiments/metrics/tracking/tracking_scores.h"

namespace cvo {

// The boxes of `category` ("Car", "Pedestrian") that KITTI's tracking benchmark counts, by the
// rules of TrackEval: true ones with occlusion of at most 2 and truncation 0; of the reported ones,
// those matched in the image (similarity 0.5) to another true box or to a neighbour class (van,
// person) are left out, and of the unmatched ones those of at most 25 px in height or with more
// than half of their area in a DontCare region. `space` is that of the similarity; what counts is
// decided in the image. Throws Error where a track has two boxes in a frame.
TrackedSequence CountedBoxes(const std::vector<ApFrame>& frames, const std::string& category,
                             BoxSpace space);

}  // namespace cvo
