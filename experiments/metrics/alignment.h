// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/pose_errors.h"

namespace cvo {

// How an estimated trajectory is aligned with its reference.
enum class TrajectoryAlignment {
  kNone,
  kSe3,     // rotation and translation, least squares over positions
  kSim3,    // the same with a scale (Umeyama 1991)
  kOrigin,  // the first common pose coincides
  kYaw,     // rotation about the vertical and translation, least squares over positions
};
// Parses "none", "se3", ...; throws Error for any other text.
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
