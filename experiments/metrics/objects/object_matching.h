// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "experiments/metrics/objects/object_estimate.h"

namespace cvo {

// A body and the cluster it is scored with.
struct ObjectMatch {
  std::size_t body = 0;     // index into ObjectTruth::bodies
  std::size_t cluster = 0;  // index into ObjectEstimate::clusters
  double shared = 0.0;      // landmarks of the cluster on the body, or nearness, over all frames
};

// One-to-one, such that what matched pairs share (ObjectEstimate::match_by: landmarks or nearness)
// is as much as possible; pairs that share nothing stay apart. By body.
std::vector<ObjectMatch> MatchObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

// How steadily a body is followed, over its visible frames. Its cluster in a frame is the one with
// the most landmarks on it, at least kMinObservedLandmarks; ties: the one before, then the lowest
// id. By nearness: the one of the one-to-one pairs that share the most in the frame.
struct Continuity {
  int id_switches = 0;  // another cluster than the last time it had one, also across occlusions
  int fragments = 0;    // has a cluster again after visible frames without
};
std::vector<Continuity> MeasureContinuity(const ObjectTruth& truth,
                                          const ObjectEstimate& estimate);  // [body]

// How near each cluster is to each body in a frame, [body, cluster]: 1 - d / r with the distance d
// between their centres and the diagonal r of the body's box, wide enough for an object's frame at
// its edge; 0 beyond it and where one of the two or a camera is not there. Either centre is seen
// from its own camera, so that drift is no matter.
Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame);

}  // namespace cvo
