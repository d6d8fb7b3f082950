// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

struct TimedPose {
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_camera;
};

// Poses with strictly increasing timestamps.
using Trajectory = std::vector<TimedPose>;

// Interpolates the pose at a time: linear in position, along the shortest arc in rotation. Empty
// outside the time range of the trajectory.
[[nodiscard]] std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory,
                                                            std::int64_t time_ns);

// TUM trajectory files: "time tx ty tz qx qy qz qw" per line, time in seconds, comments after #.
// Reading is strict (finite numbers, unit quaternions to within 1e-3, increasing times) and throws
// Error with file and line. Written files read back as the same trajectory, with times exact to 1
// ns.
Trajectory ReadTumTrajectory(const std::filesystem::path& path);
std::string FormatTumTrajectory(const Trajectory& trajectory);

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line. Written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);

// Returns "tum" or "kitti", from the number of columns in the first line that is not a comment.
// Throws Error with file and line.
std::string DetectPoseFormat(const std::filesystem::path& path);

// Returns "<path>:<line>" of the pose with this index (from 0) in a file that ReadTumTrajectory
// reads.
std::string WhereTumPose(const std::filesystem::path& path, std::size_t index);

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
