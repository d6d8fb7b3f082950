// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_track.h"

namespace cvo {

// How clusters are matched by descriptors alone, without a prediction (paper, end of section 3.1).
// Rematch searches the boxes that were assigned to clusters. Reacquire searches the remaining boxes
// for clusters that were not found, archived ones included (`archived` holds their predictions).
template <typename Policy>
concept BoxRematchPolicy = requires(const ClusterSearch& search,
                                    const std::vector<PredictedCluster>& archived, ClusterMap& map,
                                    Rng& rng, TakenFeatures& taken,
                                    std::vector<ClusterTrack>& tracks) {
  Policy::Rematch(search, map, rng, taken, tracks);
  Policy::Reacquire(search, archived, map, rng, taken, tracks);
};

// Policy: compares the descriptors in the box with those of the cluster's unmatched landmarks and
// keeps the matches that agree on a pose.
struct RematchInBox {
  static void Rematch(const ClusterSearch& search, const ClusterMap& map, Rng& rng,
                      TakenFeatures& taken, std::vector<ClusterTrack>& tracks);
  static void Reacquire(const ClusterSearch& search, const std::vector<PredictedCluster>& archived,
                        ClusterMap& map, Rng& rng, TakenFeatures& taken,
                        std::vector<ClusterTrack>& tracks);
};
// Policy: searches only the boxes that were assigned to clusters, as in the paper.
struct RematchInOwnBox : RematchInBox {
  static void Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&, ClusterMap&,
                        Rng&, TakenFeatures&, std::vector<ClusterTrack>&) {}
};
// Policy: no matching without a prediction.
struct NoBoxRematch {
  static void Rematch(const ClusterSearch&, const ClusterMap&, Rng&, TakenFeatures&,
                      std::vector<ClusterTrack>&) {}
  static void Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&, ClusterMap&,
                        Rng&, TakenFeatures&, std::vector<ClusterTrack>&) {}
};

}  // namespace cvo
