// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clustering/point_extent.h"

namespace cvo {

// Finds the dense ranges of depths among the points in a box. Returns the points of each range as
// ascending indices into depths_m, the nearest range first. `angular_size` is the larger side of
// the box over the focal length. Depths that are not positive and finite are ignored.
std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size,
                                         const ExtentOptions& options);

}  // namespace cvo
