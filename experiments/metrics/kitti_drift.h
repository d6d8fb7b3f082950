// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Drift as defined by the KITTI odometry devkit: the mean error of the relative pose, per metre,
// over sub-sequences of 100, 200, ..., 800 m along the true path that start at every tenth frame.
struct KittiDrift {
  double translation_percent = 0.0;
  double rotation_deg_per_100m = 0.0;
  std::int64_t segments = 0;
  std::int64_t segments_without_estimate = 0;
};
// Empty if no sub-sequence has an estimate at both ends. The path across frames without truth is
// taken as a straight line; a sub-sequence whose first frame has no truth is left out.
[[nodiscard]] std::optional<KittiDrift> ComputeKittiDrift(const OptionalPoses& truth,
                                                          const OptionalPoses& estimate);

}  // namespace cvo
