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
// Throws Error if the lengths differ or a pose is not finite.
CommonPoses FindCommonPoses(const OptionalPoses& truth, const OptionalPoses& estimate);

// Positions of the poses, one per column.
Eigen::Matrix3Xd Positions(const std::vector<RigidTransform>& poses);

// Position errors (m) after the SE(3) alignment of the estimated positions to the true ones.
std::vector<double> AlignedPositionErrors(const CommonPoses& poses);

// Root mean squares of E = (G_i^-1 G_j)^-1 (P_i^-1 P_j) over pairs of frames.
struct RelativeErrors {
  std::optional<double> rotation_rad;
  double translation_m = 0.0;
  std::int64_t pairs = 0;
};
// Largest number of poses for which the rotations of all pairs are computed. Unlike the
// translations, they have no closed-form sum, so beyond this it takes too long.
inline constexpr std::size_t kMaxPairedRotations = 100'000;
// Over all ordered pairs i != j; empty for fewer than two poses. Beyond kMaxPairedRotations poses,
// rotation_rad is empty.
[[nodiscard]] std::optional<RelativeErrors> AllPairsErrors(const CommonPoses& poses);
// Over the pairs (i, i + 1) of consecutive frames; empty if there are none.
[[nodiscard]] std::optional<RelativeErrors> OneFrameErrors(const CommonPoses& poses);
// The same for motions in the world, which do not depend on the choice of the body frame:
//   E = G_i^-1 (G_j G_i^-1)^-1 (P_j P_i^-1) G_i.
[[nodiscard]] std::optional<RelativeErrors> MotionErrors(const CommonPoses& poses);

// Lengths of the paths over the pairs (i, i + 1) of consecutive frames; empty if there are none.
struct ComparedPaths {
  double truth_m = 0.0;
  double estimate_m = 0.0;
  std::int64_t pairs = 0;
};
[[nodiscard]] std::optional<ComparedPaths> ConsecutiveLengths(const CommonPoses& poses);

}  // namespace cvo
