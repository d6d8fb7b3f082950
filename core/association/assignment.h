// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo {

// Kuhn-Munkres: the column of each row, or -1. Infinity forbids a pair. As many pairs as can be,
// of those the least total cost; of equal totals the one where row 0 has the lowest column, then
// row 1 and so on (none is higher than any; costs closer than 1e-12 of the largest are equal).
// O(rows * columns * the smaller). Throws Error on NaN or minus infinity.
std::vector<int> Assign(const Eigen::MatrixXd& cost);

}  // namespace cvo
