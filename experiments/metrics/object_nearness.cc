// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/object_nearness.h"

#include <algorithm>

namespace cvo {
namespace {

// nullptr where the cluster is not in the frame.
const ClusterFrame* FindFrame(const ClusterEstimate& cluster, std::size_t frame) {
  const auto found = std::lower_bound(
      cluster.frames.begin(), cluster.frames.end(), static_cast<int>(frame),
      [](const ClusterFrame& candidate, int value) { return candidate.frame < value; });
  return found == cluster.frames.end() || found->frame != static_cast<int>(frame) ? nullptr
                                                                                  : &*found;
}

}  // namespace

Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame) {
  Eigen::MatrixXd nearness =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.bodies.size()),
                            static_cast<Eigen::Index>(estimate.clusters.size()));
  const auto& true_camera = truth.world_from_camera[frame];
  const auto& camera = estimate.world_from_camera[frame];
  if (!true_camera || !camera) return nearness;
  for (std::size_t c = 0; c < estimate.clusters.size(); ++c) {
    const ClusterFrame* cluster = FindFrame(estimate.clusters[c], frame);
    if (cluster == nullptr) continue;
    const Eigen::Vector3d center_in_camera =
        camera->Inverse() * (cluster->world_from_object * cluster->center_in_object);
    for (std::size_t b = 0; b < truth.bodies.size(); ++b) {
      const TruthBody& body = truth.bodies[b];
      if (!body.frames[frame] || body.diagonal_m <= 0.0) continue;
      const Eigen::Vector3d true_in_camera =
          true_camera->Inverse() * body.frames[frame]->world_from_object.translation();
      nearness(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(c)) =
          std::max(0.0, 1.0 - (center_in_camera - true_in_camera).norm() / body.diagonal_m);
    }
  }
  return nearness;
}

}  // namespace cvo
