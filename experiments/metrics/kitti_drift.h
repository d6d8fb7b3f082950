// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Drift as the KITTI odometry devkit takes it: over sub-sequences of 100, 200, ..., 800 m along the
// true path that start at every tenth frame, the mean error of their relative pose per metre.
struct KittiDrift {
  double translation_percent = 0.0;
  double rotation_deg_per_100m = 0.0;
  std::int64_t segments = 0;
  std::int64_t segments_without_estimate = 0;
};
// Empty where no sub-sequence has an estimate at both its ends. Frames without truth are bridged by
// a straight line; a sub-sequence that would start at one is left out.
[[nodiscard]] std::optional<KittiDrift> ComputeKittiDrift(const OptionalPoses& truth,
                                                          const OptionalPoses& estimate);

}  // namespace cvo
