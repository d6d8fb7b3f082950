// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/record/body_row.h"

namespace cvo::reports {

// Root mean square errors of both over the frames that both have. Empty if they have no frame in
// common.
std::optional<std::pair<double, double>> CommonRootMeanSquares(const FrameErrors& a,
                                                               const FrameErrors& b);

// Distances (m) between estimated and true positions of the same index, after applying to the
// estimate the rotation and translation that minimise the sum of their squares (AlignPoints), as
// for camera ATE. Both lists must have the same size.
std::vector<double> AlignedErrors(const std::vector<std::array<double, 3>>& estimate,
                                  const std::vector<std::array<double, 3>>& truth);

}  // namespace cvo::reports
