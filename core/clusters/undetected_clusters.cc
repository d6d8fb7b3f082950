// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/undetected_clusters.h"

#include "core/estimation/camera_solver.h"

namespace cvo {

bool StandsStill(const Window& window, const FeatureNoise& noise, FrameId newest,
                 const Cluster& cluster) {
  int still = 0;
  int moved = 0;
  for (const Landmark& landmark : cluster.landmarks) {
    if (landmark.last_seen != newest || landmark.observations.size() < 2) continue;
    const Observation& earliest = landmark.observations.front();
    const WindowFrame* frame = window.Find(earliest.frame);
    if (!frame) continue;
    // A point that has not moved was seen there from where it is now.
    const PointMeasurement now{cluster.Latest().world_from_object * landmark.p_in_object,
                               earliest.z_px, noise.SqrtInformation(earliest)};
    const auto error = WhitenedError(window.camera, now, frame->world_from_camera.Inverse());
    ++(error && error->squaredNorm() <= noise.options.gate ? still : moved);
  }
  return still > 0 && still >= moved;
}

void ArchiveUndetected(const Window& window, const FeatureNoise& noise, FrameId newest,
                       const ClusterOptions& options, ClusterMap& map) {
  if (options.undetected_frames == 0) return;
  std::erase_if(map.live, [&](const Cluster& cluster) {
    const bool is_undetected =
        newest.value - cluster.last_detected.value >= options.undetected_frames;
    const bool is_archived = is_undetected && IsConfirmed(cluster, options) &&
                             !cluster.given_body.valid() &&
                             StandsStill(window, noise, newest, cluster);
    if (is_archived) map.archived.push_back(cluster);
    return is_archived;
  });
}

}  // namespace cvo
