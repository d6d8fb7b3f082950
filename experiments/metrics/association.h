// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

constexpr std::int64_t kDefaultAssociation_ns = 20'000'000;

// One-to-one pairs of poses whose timestamps differ by at most the tolerance. The nearest in time
// are paired first; ties are broken by the index in a, then in b.
struct TimeAssociation {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // indices into a and b, increasing in a
  std::size_t unmatched_a = 0;
  std::size_t unmatched_b = 0;
};
TimeAssociation AssociateByTime(const Trajectory& a, const Trajectory& b,
                                std::int64_t tolerance_ns = kDefaultAssociation_ns);

// Returns the estimated pose of each frame of the truth; empty for a frame that has none.
std::vector<std::optional<RigidTransform>> PosesAtFrames(const TimeAssociation& truth_estimate,
                                                         std::size_t truth_frames,
                                                         const Trajectory& estimate);

}  // namespace cvo
