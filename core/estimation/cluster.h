// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/estimation/landmark.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// x_t^q of the paper: a cluster in one frame.
struct ClusterState {
  FrameId frame;
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of its origin, in world
};

// Where a body's centre is, from the boxes that show it, in the body's frame. A box tells well
// across the line of sight and badly along it: seen from several sides, the centre is fixed.
struct CenterEstimate {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();  // information * centre
  int boxes = 0;

  void Add(const Eigen::Vector3d& center, const Eigen::Matrix3d& information_of_box);
  // Both of a frame that `object_from_there` leads out of.
  void Add(const RigidTransform& object_from_there, const Eigen::Vector3d& center_there,
           const Eigen::Matrix3d& information_there);
  void Add(const CenterEstimate& other);  // of the same frame
  // The origin without a box.
  Eigen::Vector3d InObject() const;
  // Of the centre, m^2: that of a single box, because boxes that show the same side of a body are
  // wrong by the same amount. Needs a box.
  Eigen::Matrix3d Covariance() const;
  // The same in another frame of the body.
  CenterEstimate In(const RigidTransform& new_from_old) const;
};

// Smaller side of the last box that showed a whole body, m; until then its size is at least that of
// the largest part of it.
struct BodySize {
  double side_m = 0.0;  // 0: no box told
  bool is_whole = false;

  void Add(double side_of_box_m, bool box_is_whole);
};

// How a body moves at one time, and how well that is known.
struct BodyMotion {
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of its origin, in world
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();    // in world
  double speed_variance_m2_s2 = 0.0;                       // each axis
  double turn_variance_rad2_s2 = 0.0;
};

// What a cluster knows of itself from before it was lost, until it is aligned with that: its frame
// since `since` is a guess.
struct Lineage {
  FrameId since;
  std::vector<Landmark> landmarks;  // in its frame as it was
  CenterEstimate box_center;
  BodyMotion last;         // in its frame as it was
  bool is_placed = false;  // by enough boxes: landmarks alone move it still
};

// A rigid body that moves or may move. Its frame is arbitrary and stays what it was at birth.
struct Cluster {
  ClusterId id;
  std::string category;
  BodyId given_body;                 // as GivenKnowledge says; invalid: unknown
  std::vector<ClusterState> states;  // in frames of T_t that see it, oldest first; never empty
  std::vector<Landmark> landmarks;   // by id
  // Box around its landmarks along the axes of its frame: the p30/p70 centre and half sides.
  Eigen::Vector3d center_in_object = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  BodySize size;
  CenterEstimate box_center;
  Lineage former;
  FrameId last_observed;
  FrameId last_detected;
  FrameId lost_before;  // where it was looked for back in time: it is not in the frame before
  int frames = 1;       // that saw it, ever
  int detection = -1;   // index of the last frame's associated one; -1: none
  int detections = 0;   // frames with an associated one
  double score = 0.0;   // of the last one

  const ClusterState& Latest() const { return states.back(); }
};

// The cluster's state in the frame; null where there is none.
const ClusterState* FindState(const Cluster& cluster, FrameId frame);

// Seconds from one timestamp to another.
inline double SecondsBetween(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace cvo
