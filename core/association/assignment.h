// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo {

// Solves the assignment problem (Kuhn-Munkres). Returns the column of each row, or -1. A cost of
// infinity forbids a pair. The assignment has as many pairs as possible and, among those
// assignments, the least total cost. Of equal totals, it is the one in which row 0 has the lowest
// column, then row 1, and so on; no column at all ranks behind every column. Costs that differ by
// less than 1e-12 of the largest are equal. O(rows * columns * min(rows, columns)). Throws Error on
// NaN or minus infinity.
std::vector<int> Assign(const Eigen::MatrixXd& cost);

}  // namespace cvo
