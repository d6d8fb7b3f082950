// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/clustering/dense_crf.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Observation of a landmark in a frame of the window.
struct Observation {
  FrameId frame;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // (u_left, v, u_right)
  int octave = 0;
  bool is_aligned = false;       // to the reference patch of the landmark
  float disagreement_px = 0.0F;  // between the quarters of its stereo patch, px of the level
};

// The patch that later features of a landmark are aligned with: its appearance when it was first
// seen, renewed when its scale in the image has changed by too much or alignment has failed
// (METHOD.md 3.4).
struct LandmarkReference {
  FeaturePatch patch;
  // Depth times the scale of the pyramid level: the size of a pixel of the patch at the landmark,
  // times the focal length.
  double size_m = 0.0;
};

// Covariance of the best single triangulation of a landmark, the one with the smallest determinant
// (Eq. 1 of the paper; kept in the body frame so that it turns with the body: METHOD.md 4.1).
struct LandmarkCovariance {
  Eigen::Matrix3d in_object_m2 = Eigen::Matrix3d::Identity();
  double determinant = std::numeric_limits<double>::infinity();
};

// A point of a rigid body: of the static scene (q = 0 in the paper), whose body frame is the world,
// or of a cluster.
struct Landmark {
  LandmarkId id;
  Eigen::Vector3d p_in_object = Eigen::Vector3d::Zero();
  std::vector<Observation> observations;  // in frames of the window, oldest first
  Descriptor descriptor{};                // of the last observation
  LandmarkReference reference;
  double depth_m = 0.0;  // at the last observation; with last_octave it predicts the next octave
  int last_octave = 0;
  FrameId last_seen;
  LabelState label;  // q^i and w^i

  LandmarkCovariance covariance;
  // Information on p_in_object from a cluster's observations that have left the window (METHOD.md
  // 8.4), and the position on which they agree.
  Eigen::Matrix3d past_information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d past_mean_in_object = Eigen::Vector3d::Zero();
};

// Returns the landmark's observation in the frame; null if there is none.
const Observation* FindObservation(const Landmark& landmark, FrameId frame);

// State of a cluster in one frame: x_t^q of the paper.
struct ClusterState {
  FrameId frame;
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of its origin, in world
};

// Estimate of a rigid body that moves or may move. Its body frame is arbitrary: it is chosen at
// birth and kept.
struct Cluster {
  ClusterId id;
  std::string category;
  BodyId given_body;                 // from GivenKnowledge; invalid: unknown
  std::vector<ClusterState> states;  // for the frames of T_t that see it, oldest first; never empty
  std::vector<Landmark> landmarks;   // sorted by id
  // Box around the landmarks along the axes of the body frame: centre and half sides of the range
  // between the 30th and 70th percentiles.
  Eigen::Vector3d center_in_object = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  FrameId last_observed;
  FrameId last_detected;
  // First tracked frame of the last failed trace back, which is not repeated from there.
  FrameId lost_before;
  int frames = 1;      // number that ever saw it
  int detection = -1;  // index of the detection associated in the last frame; -1: none
  int detections = 0;  // number of frames with an associated detection
  double score = 0.0;  // of the last associated detection

  const ClusterState& Latest() const { return states.back(); }
};

// Returns the cluster's state in the frame; null if it has none.
inline const ClusterState* FindState(const Cluster& cluster, FrameId frame) {
  const auto it = std::ranges::lower_bound(cluster.states, frame, {}, &ClusterState::frame);
  return it != cluster.states.end() && it->frame == frame ? &*it : nullptr;
}

// Returns the time from one timestamp to the other, s.
inline double SecondsBetween(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace cvo
