// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "experiments/metrics/pose_errors.h"
#include "reports/results/body_row.h"

namespace cvo {

// The largest errors over a run, by the three contracts of reports::Alignment (METHOD.md 10.5);
// `truth_from_estimate` are the worlds of kAllPoses. Another constant frame of the body in the
// estimate, P_t B for P_t, gives the same. Empty with fewer than two poses.
[[nodiscard]] std::optional<reports::MaxDrifts> MeasureMaxDrift(
    const CommonPoses& poses, const RigidTransform& truth_from_estimate);

// X of the contracts by motions, from the first `frames` poses.
RigidTransform AlignByMotions(const CommonPoses& poses, std::size_t frames);

// The worlds in which the first common poses are the same; the identity without one.
RigidTransform AlignAtFirst(const CommonPoses& poses);

}  // namespace cvo
