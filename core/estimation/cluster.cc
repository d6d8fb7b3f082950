// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/cluster.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace cvo {

void CenterEstimate::Add(const Eigen::Vector3d& center, const Eigen::Matrix3d& information_of_box) {
  information += information_of_box;
  weighted += information_of_box * center;
  ++boxes;
}

void CenterEstimate::Add(const RigidTransform& object_from_there,
                         const Eigen::Vector3d& center_there,
                         const Eigen::Matrix3d& information_there) {
  const Eigen::Matrix3d R = object_from_there.RotationMatrix();
  Add(object_from_there * center_there, R * information_there * R.transpose());
}

void CenterEstimate::Add(const CenterEstimate& other) {
  information += other.information;
  weighted += other.weighted;
  boxes += other.boxes;
}

Eigen::Vector3d CenterEstimate::InObject() const {
  if (boxes == 0) return Eigen::Vector3d::Zero();
  return information.llt().solve(weighted);
}

Eigen::Matrix3d CenterEstimate::Covariance() const {
  return boxes * information.llt().solve(Eigen::Matrix3d::Identity());
}

CenterEstimate CenterEstimate::In(const RigidTransform& new_from_old) const {
  const Eigen::Matrix3d R = new_from_old.RotationMatrix();
  CenterEstimate there = *this;
  there.information = R * information * R.transpose();
  there.weighted = there.information * (new_from_old * InObject());
  return there;
}

void BodySize::Add(double side_of_box_m, bool box_is_whole) {
  if (!box_is_whole && (is_whole || side_of_box_m < side_m)) return;
  side_m = side_of_box_m;
  is_whole = box_is_whole;
}

const ClusterState* FindState(const Cluster& cluster, FrameId frame) {
  const auto it = std::lower_bound(cluster.states.begin(), cluster.states.end(), frame,
                                   [](const ClusterState& s, FrameId id) { return s.frame < id; });
  return it != cluster.states.end() && it->frame == frame ? &*it : nullptr;
}

}  // namespace cvo
