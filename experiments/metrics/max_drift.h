// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "experiments/metrics/pose_errors.h"
#include "reports/results/body_row.h"

namespace cvo {

// Computes the largest errors over a run under the three contracts of reports::Alignment
// (METHOD.md 10.5). `truth_from_estimate` aligns the worlds for kAllPoses. The result does not
// depend on the body frame of the estimate: P_t B in place of P_t, with B constant, gives the same.
// Empty for fewer than two poses.
[[nodiscard]] std::optional<reports::MaxDrifts> MeasureMaxDrift(
    const CommonPoses& poses, const RigidTransform& truth_from_estimate);

// Returns X (object_from_gtobject) of the contracts by motions, from the first `frames` poses.
RigidTransform AlignByMotions(const CommonPoses& poses, std::size_t frames);

// Returns truth_from_estimate such that the first common poses coincide; the identity if there is
// none.
RigidTransform AlignAtFirst(const CommonPoses& poses);

}  // namespace cvo
