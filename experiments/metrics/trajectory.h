// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

struct TimedPose {
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_camera;
};

// Strictly increasing in time.
using Trajectory = std::vector<TimedPose>;

}  // namespace cvo
