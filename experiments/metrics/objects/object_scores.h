// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/record/body_row.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Scores of a run on one body. Position errors are measured after the alignment of the worlds by
// the camera and with the single object_from_gtobject of its cluster. Motion errors are those of
// E = G_k^-1 H_gt^-1 H_est G_k with H = P_k+1 P_k^-1.
struct BodyScore : reports::BodyRow {
  // Positions of the body's origin in the world of the truth, per frame of `errors` and of
  // `predicted`.
  std::vector<Eigen::Vector3d> estimated_positions;
  std::vector<Eigen::Vector3d> predicted_positions;
};

struct ObjectScores {
  MatchBy match_by = MatchBy::kLandmarks;
  bool differentiated = false;         // of velocities: ObjectEstimate::differentiated
  RigidTransform truth_from_estimate;  // between the worlds
  std::vector<BodyScore> bodies;       // those visible in some frame, by id
  int clusters = 0;                    // number of clusters whose pose counts in some frame
  int unmatched_clusters = 0;          // of these, not matched to a body
};

// Aligns the world of the estimate to that of the truth by the camera: the rotation is the chordal
// mean over the camera's orientations, the translation the mean over its positions. Returns
// truth_from_estimate; the identity if no frame has both poses.
RigidTransform AlignByCamera(const OptionalPoses& truth, const OptionalPoses& estimate);

// Throws Error as CheckEstimate does.
ObjectScores ScoreObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

// Computes the object metrics, in a fixed order: object_* over moving bodies, object_predicted_*
// over the frames in which their estimate does not count (Counts), object_standing_* over
// stationary bodies, and the number of clusters without a body. A metric that the bodies do not
// determine is absent.
std::vector<Metric> ObjectMetrics(const ObjectTruth& truth, const ObjectScores& scores);

// Measures how well observed landmarks are assigned to bodies: moving_precision and moving_recall;
// cluster_purity, which also counts stationary bodies; clustering_iou (the cluster of a body is
// that of `matches`) and clustering_ari. Landmarks of unknown truth, and those on a body that has
// not moved yet, are left out. Landmarks on a body that has stopped still count as that body's.
// A metric that the landmarks do not determine is absent.
std::vector<Metric> ClusteringMetrics(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                      const std::vector<ObjectMatch>& matches);

// Adjusted Rand index of two labellings of the same items (Hubert and Arabie 1985). An item with a
// negative label is a group of its own. 1 if both labellings agree on every pair.
double AdjustedRandIndex(const std::vector<int>& a, const std::vector<int>& b);

}  // namespace cvo
