// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/kitti_ap/average_precision.h"
#include "experiments/metrics/tracking/tracking_scores.h"

namespace cvo {

// Selects the boxes of `category` ("Car", "Pedestrian") that KITTI's tracking benchmark counts, by
// the rules of TrackEval. True boxes count if their occlusion is at most 2 and their truncation 0.
// Reported boxes do not count if they match, in the image (similarity 0.5), a true box that does
// not count or one of a neighbouring class (van, person), nor if they are unmatched and either at
// most 25 px high or with more than half of their area in a DontCare region. `space` is that of the
// similarity in the result; which boxes count is decided in the image. Throws Error if a track has
// two boxes in a frame.
TrackedSequence CountedBoxes(const std::vector<ApFrame>& frames, const std::string& category,
                             BoxSpace space);

}  // namespace cvo
