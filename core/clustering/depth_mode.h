// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clustering/point_extent.h"

namespace cvo {

// Of the points in a box of angular_size (larger side over focal length), those that make a dense
// range of depths, for each such range, the nearest first; ascending indices. `depths_m` that are
// not positive are left out.
std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size,
                                         const ExtentOptions& options);

}  // namespace cvo
