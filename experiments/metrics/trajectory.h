// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/metrics/trajectory_file.h"

namespace cvo {

// Interpolates the pose at a time: linear in position, along the shortest arc in rotation. Empty
// outside the time range of the trajectory.
[[nodiscard]] std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory,
                                                            std::int64_t time_ns);

constexpr std::int64_t kDefaultAssociation_ns = 20'000'000;

// One-to-one pairs of poses whose timestamps differ by at most the tolerance. The nearest in time
// are paired first; ties are broken by the index in a, then in b.
struct TimeAssociation {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // indices into a and b, increasing in a
  std::size_t unmatched_a = 0;
  std::size_t unmatched_b = 0;
};
using Times = std::vector<std::int64_t>;  // ns, strictly increasing
Times TimesOf(const Trajectory& trajectory);
TimeAssociation AssociateByTime(const Times& a, const Times& b, std::int64_t tolerance_ns);
TimeAssociation AssociateByTime(const Trajectory& a, const Trajectory& b,
                                std::int64_t tolerance_ns = kDefaultAssociation_ns);

// Returns the estimated pose of each frame of the truth; empty for a frame that has none.
std::vector<std::optional<RigidTransform>> PosesAtFrames(const TimeAssociation& truth_estimate,
                                                         std::size_t truth_frames,
                                                         const Trajectory& estimate);

// How an estimated trajectory is aligned with its reference.
enum class TrajectoryAlignment {
  kNone,
  kSe3,     // rotation and translation, least squares over positions
  kSim3,    // the same with a scale (Umeyama 1991)
  kOrigin,  // the first common pose coincides
  kYaw,     // rotation about the vertical and translation, least squares over positions
};
constexpr std::array<const char*, 5> EnumNames(TrajectoryAlignment) {
  return {"none", "se3", "sim3", "origin", "yaw"};
}
// Throws Error for a text that is not one of these names.
TrajectoryAlignment ParseTrajectoryAlignment(const std::string& text);
// Returns a description such as "aligned by SE(3) over positions".
std::string DescriptionOf(TrajectoryAlignment alignment);

// Similarity transform p -> scale R p + t.
struct Similarity {
  double scale = 1.0;
  RigidTransform rigid;

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rigid * (scale * point); }
  RigidTransform operator*(const RigidTransform& pose) const {
    return {Eigen::Quaterniond(rigid.rotation() * pose.rotation()), *this * pose.translation()};
  }
};

// Computes truth_from_estimate. `up` is the unit vector about which kYaw rotates. Throws Error if
// there are no poses, or if they do not determine a scale.
Similarity AlignTrajectory(const CommonPoses& poses, TrajectoryAlignment alignment,
                           const Eigen::Vector3d& up);

// Angles (rad) between true and aligned orientations. Positions alone hardly determine the rotation
// about a straight path; with kSe3 and kSim3, orientations are therefore aligned by their own
// chordal mean.
std::vector<double> OrientationErrors(const CommonPoses& poses, TrajectoryAlignment alignment,
                                      const Similarity& truth_from_estimate);

// Returns the object_from_gtobject that best aligns the estimated poses with the true ones, both in
// the same world (METHOD.md 10.2). Requires at least one pair.
RigidTransform AlignObject(const CommonPoses& poses);

}  // namespace cvo
