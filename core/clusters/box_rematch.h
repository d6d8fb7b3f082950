// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_track.h"

namespace cvo {

// How clusters are matched by descriptors alone, without a prediction, inside the box that each was
// given (paper, end of section 3.1).
template <typename Policy>
concept BoxRematchPolicy = requires(const FrameView& view, const ClusterMap& map, Rng& rng,
                                    TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  Policy::Rematch(view, map, rng, taken, tracks);
};

// Policy: descriptors in the box are compared with all of the cluster's landmarks and checked by
// the pose.
struct RematchInBox {
  static void Rematch(const FrameView& view, const ClusterMap& map, Rng& rng, TakenFeatures& taken,
                      std::vector<ClusterTrack>& tracks);
};
// Policy: nothing.
struct NoBoxRematch {
  static void Rematch(const FrameView&, const ClusterMap&, Rng&, TakenFeatures&,
                      std::vector<ClusterTrack>&) {}
};

}  // namespace cvo
