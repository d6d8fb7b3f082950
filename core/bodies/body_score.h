// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clusters/frame_view.h"
#include "core/estimation/cluster.h"

namespace cvo {

// Confidence, in (0, 1), that a body is where the cluster is estimated in frame `newest`, for
// ranking estimates (METHOD.md 10.1). `view` is null in a frame without images.
double ScoreOf(const FeatureNoise& noise, const ClusterOptions& options, const FrameView* view,
               FrameId newest, const Cluster& cluster);

}  // namespace cvo
