// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"

namespace cvo {

// A confirmed cluster that is out of sight, live or archived, as predicted for now.
struct LostCluster {
  ClusterId id;
  PredictedCluster predicted;
};

// Clusters confirmed in this frame whose place and size one lost cluster of their class explains,
// and no other nearly as well, go on under its id: a body that turned while it was hidden shows
// none of its old landmarks. Their frame becomes the lost one's, whose origin is their own and
// whose rotation is predicted.
void InheritIdentities(const std::vector<LostCluster>& lost, FrameId newest,
                       const ClusterAssociationOptions& association, const ClusterOptions& options,
                       ClusterMap& map);

// Clusters that go on under an earlier id: their frame is aligned with what it was, by landmarks
// that look alike, until then, after enough boxes, by the centres that they show.
void AlignWithFormer(const Options& options, FrameId newest, ClusterMap& map, Rng& rng);

// The lost clusters of the map at a time.
template <typename Variant>
std::vector<LostCluster> FindLostClusters(const Options& options, FrameId newest,
                                          std::int64_t timestamp_ns, const ClusterMap& map) {
  std::vector<LostCluster> lost;
  const auto add = [&](const Cluster& cluster) {
    if (cluster.last_observed == newest || !IsConfirmed(cluster, options.clusters)) return;
    lost.push_back(
        {cluster.id, PredictCluster<typename Variant::MotionPrior, typename Variant::Rotation>(
                         cluster, timestamp_ns, options.motion_prior, options.clusters)});
  };
  for (const Cluster& cluster : map.live) add(cluster);
  for (const Cluster& cluster : map.archived) add(cluster);
  return lost;
}

}  // namespace cvo
