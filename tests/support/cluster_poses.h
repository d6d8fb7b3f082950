// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/interface/odometry.h"

namespace cvo::test {

// Returns one frame of a cluster trajectory. Fields that are not given are taken from `report`.
inline ClusterPose PoseInFrame(std::int64_t frame, std::int64_t timestamp_ns, ClusterStatus status,
                               const RigidTransform& world_from_object, ClusterReport report = {}) {
  report.status = status;
  report.world_from_object = world_from_object;
  return {report, frame, timestamp_ns};
}

}  // namespace cvo::test
