// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metrics/object_matching.h"

namespace cvo {

// The position error of a body in a frame, after the alignment of the camera and with the one
// object_from_gtobject of its cluster.
struct ObjectFrameError {
  int frame = 0;
  double position_m = 0.0;
  Eigen::Vector3d estimate = Eigen::Vector3d::Zero();  // of the body's origin, world of the truth
};

// What a run reaches on one body. Root mean squares over the body's frames; empty where the frames
// do not determine one.
struct BodyScore {
  int id = 0;
  std::string name;
  std::string category;
  bool mover = false;
  double travel_m = 0.0;
  std::int64_t cluster = -1;  // its id; -1: none
  int visible_frames = 0;
  int estimated_frames = 0;  // visible ones where the estimate counts
  Continuity continuity;
  std::vector<ObjectFrameError> errors;     // in these
  std::vector<ObjectFrameError> predicted;  // where the pose is a prediction, visible or not
  std::optional<double> ate_m;
  std::optional<double> predicted_ate_m;
  std::optional<RelativeErrors> all_pairs;
  std::optional<RelativeErrors> one_frame;
  std::optional<RelativeErrors> motion;  // E = G_k^-1 H_gt^-1 H_est G_k, H = P_k+1 P_k^-1
  std::optional<double> velocity_m_s;
};

struct ObjectScores {
  MatchBy match_by = MatchBy::kLandmarks;
  RigidTransform truth_from_estimate;  // of the worlds
  std::vector<BodyScore> bodies;       // that are visible in some frame, by id
  int clusters = 0;                    // whose pose counts in some frame
  int unmatched_clusters = 0;          // of these, scored with no body
};

// The world of the truth from that of the estimate by the camera: rotation the chordal mean over
// its orientations, translation over its positions. The identity without a common frame.
RigidTransform AlignByCamera(const OptionalPoses& truth, const OptionalPoses& estimate);

// object_from_gtobject that brings the estimated poses nearest to the true ones of the same world
// (METHOD.md 10.2). At least one pair.
RigidTransform AlignObject(const CommonPoses& poses);

// Throws Error as CheckEstimate.
ObjectScores ScoreObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

}  // namespace cvo
