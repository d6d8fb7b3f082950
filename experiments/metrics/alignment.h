// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/pose_errors.h"

namespace cvo {

// How an estimated trajectory is brought to its reference.
enum class TrajectoryAlignment {
  kNone,
  kSe3,     // rotation and translation, least squares over positions
  kSim3,    // the same with a scale (Umeyama 1991)
  kOrigin,  // the first common pose coincides
  kYaw,     // rotation about the vertical and translation, least squares over positions
};
// "none", "se3", ...; throws Error for another text.
TrajectoryAlignment ParseTrajectoryAlignment(const std::string& text);
// "aligned by SE(3) over positions".
std::string DescriptionOf(TrajectoryAlignment alignment);

// p -> scale R p + t.
struct Similarity {
  double scale = 1.0;
  RigidTransform rigid;

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rigid * (scale * point); }
  RigidTransform operator*(const RigidTransform& pose) const {
    return {Eigen::Quaterniond(rigid.rotation() * pose.rotation()), *this * pose.translation()};
  }
};

// Truth from estimate; `up` is the direction, of length 1, about which kYaw rotates. Throws Error
// without poses, and where they do not determine a scale.
Similarity AlignTrajectory(const CommonPoses& poses, TrajectoryAlignment alignment,
                           const Eigen::Vector3d& up);

// Angles (rad) between true and aligned orientations. Positions alone hardly determine the rotation
// about a straight path: after kSe3 and kSim3 orientations are aligned by their own chordal mean.
std::vector<double> OrientationErrors(const CommonPoses& poses, TrajectoryAlignment alignment,
                                      const Similarity& truth_from_estimate);

// object_from_gtobject that brings the estimated poses nearest to the true ones of the same world
// (METHOD.md 10.2). At least one pair.
RigidTransform AlignObject(const CommonPoses& poses);

}  // namespace cvo
