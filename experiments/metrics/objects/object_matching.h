// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "experiments/metrics/objects/object_estimate.h"

namespace cvo {

// A body and the cluster that it is scored with.
struct ObjectMatch {
  std::size_t body = 0;     // index into ObjectTruth::bodies
  std::size_t cluster = 0;  // index into ObjectEstimate::clusters
  double shared = 0.0;  // sum over frames of the cluster's landmarks on the body, or of nearness
};

// Matches bodies and clusters one-to-one so as to maximise the total that the pairs share,
// landmarks or nearness (ObjectEstimate::match_by). Pairs that share nothing are not matched.
// Sorted by body.
std::vector<ObjectMatch> MatchObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

// How continuously a body is tracked over its visible frames. Its cluster in a frame is the one
// with the most landmarks on it, at least kMinObservedLandmarks; ties are broken in favour of its
// last cluster, then of the lowest id. With matching by nearness, it is the body's cluster in the
// one-to-one matching that maximises total nearness in the frame.
struct Continuity {
  int id_switches = 0;  // a cluster other than its last one, also across occlusions
  int fragments = 0;    // a cluster again after visible frames without one
};
std::vector<Continuity> MeasureContinuity(const ObjectTruth& truth,
                                          const ObjectEstimate& estimate);  // [body]

// Nearness [body, cluster] of each cluster to each body in a frame: 1 - d / r, where d is the
// distance between their centres and r the diagonal of the body's box. r is large enough for
// estimates whose body frame is at the edge of the body. 0 if d exceeds r, or if the body, its box,
// the cluster or a camera pose is missing. Each centre is expressed in its own camera frame, so
// that drift has no effect.
Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame);

}  // namespace cvo
