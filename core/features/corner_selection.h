// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/features/corner_score.h"

namespace cvo {

// At most `quota` corners, spread evenly: the image is divided as a quadtree, breadth first, until
// it has as many occupied leaves, and each leaf keeps its strongest corner. In reading order.
std::vector<Corner> SelectEvenly(std::vector<Corner> corners, int quota);

}  // namespace cvo
