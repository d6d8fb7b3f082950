// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "experiments/metrics/object_estimate.h"

namespace cvo {

// How near each cluster is to each body in a frame, [body, cluster]: 1 - d / r with the distance d
// between their centres and the diagonal r of the body's box, wide enough for an object's frame at
// its edge; 0 beyond it and where one of the two or a camera is not there. Either centre is seen
// from its own camera, so that drift is no matter.
Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame);

}  // namespace cvo
