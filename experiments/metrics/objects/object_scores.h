// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/objects/object_matching.h"
#include "reports/results/body_row.h"

namespace cvo {

// What a run reaches on one body. Position errors are after the alignment of the camera and with
// the one object_from_gtobject of its cluster; motion errors are of E = G_k^-1 H_gt^-1 H_est G_k
// with H = P_k+1 P_k^-1.
struct BodyScore : reports::BodyRow {
  // Of the body's origin in the world of the truth, by frame of `errors` and of `predicted`.
  std::vector<Eigen::Vector3d> estimated_positions;
  std::vector<Eigen::Vector3d> predicted_positions;
};

struct ObjectScores {
  MatchBy match_by = MatchBy::kLandmarks;
  bool differentiated = false;         // velocities: ObjectEstimate::differentiated
  RigidTransform truth_from_estimate;  // of the worlds
  std::vector<BodyScore> bodies;       // that are visible in some frame, by id
  int clusters = 0;                    // whose pose counts in some frame
  int unmatched_clusters = 0;          // of these, scored with no body
};

// The world of the truth from that of the estimate by the camera: rotation the chordal mean over
// its orientations, translation over its positions. The identity without a common frame.
RigidTransform AlignByCamera(const OptionalPoses& truth, const OptionalPoses& estimate);

// Throws Error as CheckEstimate.
ObjectScores ScoreObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

}  // namespace cvo
