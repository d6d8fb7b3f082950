// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/interface/odometry.h"

namespace cvo::test {

// A frame of a trajectory; the rest of `report` as it is.
inline ClusterPose PoseInFrame(std::int64_t frame, std::int64_t timestamp_ns, ClusterStatus status,
                               const RigidTransform& world_from_object, ClusterReport report = {}) {
  report.status = status;
  report.world_from_object = world_from_object;
  return {report, frame, timestamp_ns};
}

}  // namespace cvo::test
