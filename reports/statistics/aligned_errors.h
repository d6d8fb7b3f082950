// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace cvo::reports {

// Distances (m) of estimated positions to the true ones of the same index, after the rotation and
// translation of the estimate that make the sum of their squares least (Horn 1987): as camera ATE
// has them. Both have the same size.
std::vector<double> AlignedErrors(const std::vector<std::array<double, 3>>& estimate,
                                  const std::vector<std::array<double, 3>>& truth);

}  // namespace cvo::reports
