// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_track.h"

namespace cvo {

// How clusters are matched by descriptors alone, without a prediction (paper, end of section 3.1).
// Rematch: inside the box that a cluster was given. Reacquire: inside the boxes left over, where
// clusters that were not found may be, archived ones included (`archived`: their predictions).
template <typename Policy>
concept BoxRematchPolicy = requires(const ClusterSearch& search,
                                    const std::vector<PredictedCluster>& archived, ClusterMap& map,
                                    Rng& rng, TakenFeatures& taken,
                                    std::vector<ClusterTrack>& tracks) {
  Policy::Rematch(search, map, rng, taken, tracks);
  Policy::Reacquire(search, archived, map, rng, taken, tracks);
};

// Policy: descriptors in the box are compared with all of the cluster's landmarks and checked by
// the pose.
struct RematchInBox {
  static void Rematch(const ClusterSearch& search, const ClusterMap& map, Rng& rng,
                      TakenFeatures& taken, std::vector<ClusterTrack>& tracks);
  static void Reacquire(const ClusterSearch& search, const std::vector<PredictedCluster>& archived,
                        ClusterMap& map, Rng& rng, TakenFeatures& taken,
                        std::vector<ClusterTrack>& tracks);
};
// Policy: inside the boxes that clusters were given alone, as the paper.
struct RematchInOwnBox : RematchInBox {
  static void Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&, ClusterMap&,
                        Rng&, TakenFeatures&, std::vector<ClusterTrack>&) {}
};
// Policy: nothing.
struct NoBoxRematch {
  static void Rematch(const ClusterSearch&, const ClusterMap&, Rng&, TakenFeatures&,
                      std::vector<ClusterTrack>&) {}
  static void Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&, ClusterMap&,
                        Rng&, TakenFeatures&, std::vector<ClusterTrack>&) {}
};

}  // namespace cvo
