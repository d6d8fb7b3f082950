// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/object_nearness.h"

#include <algorithm>
#include <optional>
#include <vector>

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

// Where the bodies of a frame are, in the camera; those without a box or a pose are not there.
std::vector<std::optional<Eigen::Vector3d>> BodiesInCamera(const ObjectTruth& truth,
                                                           std::size_t frame) {
  const RigidTransform camera_from_world = truth.world_from_camera[frame]->Inverse();
  std::vector<std::optional<Eigen::Vector3d>> centers(truth.bodies.size());
  for (std::size_t b = 0; b < centers.size(); ++b) {
    const TruthBody& body = truth.bodies[b];
    if (!body.frames[frame] || body.diagonal_m <= 0.0) continue;
    centers[b] = camera_from_world * body.frames[frame]->world_from_object.translation();
  }
  return centers;
}

}  // namespace

Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame) {
  Eigen::MatrixXd nearness =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.bodies.size()),
                            static_cast<Eigen::Index>(estimate.clusters.size()));
  if (!truth.world_from_camera[frame] || !estimate.world_from_camera[frame]) return nearness;
  const auto bodies = BodiesInCamera(truth, frame);
  const RigidTransform camera_from_world = estimate.world_from_camera[frame]->Inverse();
  for (std::size_t c = 0; c < estimate.clusters.size(); ++c) {
    const ClusterFrame* cluster = FindFrame(estimate.clusters[c], frame);
    if (cluster == nullptr) continue;
    const Eigen::Vector3d center =
        camera_from_world * (cluster->world_from_object * cluster->point_in_object);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (!bodies[b]) continue;
      nearness(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(c)) =
          std::max(0.0, 1.0 - (center - *bodies[b]).norm() / truth.bodies[b].diagonal_m);
    }
  }
  return nearness;
}

}  // namespace cvo
