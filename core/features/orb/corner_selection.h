// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/features/orb/corner_score.h"

namespace cvo {

// Selects at most `quota` corners that are evenly spread, and returns them in reading order. The
// strongest are taken first, and none is nearer to another than a distance chosen so that about
// `quota` remain (adaptive non-maximal suppression, Brown et al. 2005). Unlike a grid or a
// quadtree, the selection moves with the image content, so that the same corners are selected in
// the other image and in the next one.
std::vector<Corner> SelectEvenly(const std::vector<Corner>& corners, int quota);

}  // namespace cvo
