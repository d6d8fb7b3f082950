// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

using OptionalPoses = std::vector<std::optional<RigidTransform>>;

// Frames that have both a true and an estimated pose world_from_x.
struct CommonPoses {
  std::vector<int> frames;  // increasing
  std::vector<RigidTransform> truth;
  std::vector<RigidTransform> estimate;

  std::size_t size() const { return frames.size(); }
};
// Throws Error where the lengths differ or a pose is not finite.
CommonPoses FindCommonPoses(const OptionalPoses& truth, const OptionalPoses& estimate);

// By column.
Eigen::Matrix3Xd Positions(const std::vector<RigidTransform>& poses);

// Position errors (m) after the SE(3) alignment of the estimate's positions to the truth's.
std::vector<double> AlignedPositionErrors(const CommonPoses& poses);

// Root mean squares over pairs of frames of E = (G_i^-1 G_j)^-1 (P_i^-1 P_j).
struct RelativeErrors {
  std::optional<double> rotation_rad;
  double translation_m = 0.0;
  std::int64_t pairs = 0;
};
// Poses from which on the rotations of all pairs take too long: they have no closed sum as the
// translations have.
inline constexpr std::size_t kMaxPairedRotations = 100'000;
// Every ordered pair i != j; empty with fewer than two poses. Without rotations beyond the limit.
[[nodiscard]] std::optional<RelativeErrors> AllPairsErrors(const CommonPoses& poses);
// Pairs (i, i + 1) of consecutive frames alone; empty where there are none.
[[nodiscard]] std::optional<RelativeErrors> OneFrameErrors(const CommonPoses& poses);
// The same of the motions in the world, which do not depend on the frame that a body is given:
// E = G_i^-1 (G_j G_i^-1)^-1 (P_j P_i^-1) G_i.
[[nodiscard]] std::optional<RelativeErrors> MotionErrors(const CommonPoses& poses);

}  // namespace cvo
