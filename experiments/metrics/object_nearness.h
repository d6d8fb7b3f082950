// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "experiments/metrics/object_estimate.h"

namespace cvo {

// How near each cluster is to each body in a frame, [body, cluster]: 1 - d / D with the distance d
// between their centres and the diagonal D of the body's box; 0 beyond it and where one of the two
// or a camera is not there. Either centre is seen from its own camera, so that drift is no matter.
Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame);

}  // namespace cvo
