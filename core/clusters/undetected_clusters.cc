// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/undetected_clusters.h"

#include <algorithm>
#include <utility>

namespace cvo {
namespace {

// Whether a point that stays where it is now would have been observed there before.
bool AgreesWith(const Observation& seen, const Window& window, const FeatureNoise& noise,
                const Eigen::Vector3d& p_in_world) {
  const auto zeta_px =
      window.camera.Project(window.Find(seen.frame)->world_from_camera.Inverse() * p_in_world);
  if (!zeta_px) return false;
  const Eigen::Vector3d error = noise.SqrtInformation(seen) * (seen.z_px - *zeta_px);
  return error.squaredNorm() <= noise.options.gate;
}

}  // namespace

bool StandsStill(const Window& window, const FeatureNoise& noise, FrameId newest,
                 const Cluster& cluster) {
  int still = 0;
  int moved = 0;
  for (const Landmark& landmark : cluster.landmarks) {
    if (landmark.last_seen != newest || landmark.observations.size() < 2) continue;
    const Observation& earliest = landmark.observations.front();
    if (earliest.frame < window.temporal.front().id) continue;
    const Eigen::Vector3d p_in_world = cluster.Latest().world_from_object * landmark.p_in_object;
    ++(AgreesWith(earliest, window, noise, p_in_world) ? still : moved);
  }
  return still > 0 && still >= moved;
}

void ArchiveUndetected(const Window& window, const FeatureNoise& noise, FrameId newest,
                       const ClusterOptions& options, ClusterMap& map) {
  if (options.undetected_frames == 0) return;
  std::vector<Cluster> live;
  for (Cluster& cluster : map.live) {
    const bool is_undetected =
        newest.value - cluster.last_detected.value >= options.undetected_frames;
    if (is_undetected && IsConfirmed(cluster, options) && !cluster.given_body.valid() &&
        StandsStill(window, noise, newest, cluster)) {
      map.archived.push_back(cluster);  // a copy, without spare capacity
    } else {
      live.push_back(std::move(cluster));
    }
  }
  map.live = std::move(live);
}

}  // namespace cvo
