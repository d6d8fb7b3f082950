// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/labelling/cluster_labels.h"

namespace cvo {

// Makes the clusters that the frame's labels found, without landmarks yet: at rest, axes from the
// principal axes of their points, origin near the body's centre (METHOD.md 6.1, birth_depth).
void CreateClusters(const FrameView& view, FrameId newest, const std::vector<FramePoint>& points,
                    const FrameLabels& labels, ClusterMap& map);

}  // namespace cvo
