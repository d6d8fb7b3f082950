// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace cvo::reports {

// Distances (m) between estimated and true positions of the same index, after applying to the
// estimate the rotation and translation that minimise the sum of their squares (Horn 1987), as for
// camera ATE. Both lists must have the same size.
std::vector<double> AlignedErrors(const std::vector<std::array<double, 3>>& estimate,
                                  const std::vector<std::array<double, 3>>& truth);

}  // namespace cvo::reports
