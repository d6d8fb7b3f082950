// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/features/orb/corner_score.h"

namespace cvo {

// At most `quota` corners, spread evenly: strongest first, none nearer to another than a distance
// that is chosen so that about `quota` remain (adaptive non-maximal suppression, Brown et al.
// 2005). In reading order. Unlike a grid or a quadtree it moves with the image, so that the same
// corners are chosen again in the other image and in the next one.
std::vector<Corner> SelectEvenly(const std::vector<Corner>& corners, int quota);

}  // namespace cvo
