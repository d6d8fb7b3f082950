// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/objects/object_estimate.h"

#include "core/base/error.h"

namespace cvo {
namespace {

void CheckLength(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  ThrowError(StrCat("estimate of the ", what), StrCat(found, " frames"),
             StrCat(expected, ", as many as the truth"));
}

void CheckCluster(const ClusterEstimate& cluster, std::size_t frame_count) {
  int last = -1;
  for (const ClusterFrame& frame : cluster.frames) {
    const std::string where = StrCat("cluster ", cluster.id, ", frame ", frame.frame);
    if (frame.frame <= last || static_cast<std::size_t>(frame.frame) >= frame_count) {
      ThrowError(where, StrCat("a frame after ", last),
                 StrCat("increasing frames below ", frame_count));
    }
    last = frame.frame;
    const bool finite_velocity = !frame.velocity_m_s || frame.velocity_m_s->allFinite();
    if (!frame.world_from_object.Matrix().allFinite() || !finite_velocity ||
        !frame.point_in_object.allFinite()) {
      ThrowError(where, "a pose, velocity or point that is not finite", "finite numbers");
    }
  }
}

}  // namespace

void CheckEstimate(const ObjectTruth& truth, const ObjectEstimate& estimate) {
  CheckLength("camera", estimate.world_from_camera.size(), truth.frame_count());
  CheckLength("landmarks", estimate.landmarks.size(), truth.frame_count());
  const std::int64_t lowest = estimate.match_by == MatchBy::kLandmarks ? 1 : 0;
  std::int64_t last = lowest - 1;
  for (const ClusterEstimate& cluster : estimate.clusters) {
    if (cluster.id <= last) {
      ThrowError("estimated clusters", StrCat("cluster ", cluster.id, " after cluster ", last),
                 StrCat("ids that increase from ", lowest, " on"));
    }
    last = cluster.id;
    CheckCluster(cluster, truth.frame_count());
  }
}

}  // namespace cvo
