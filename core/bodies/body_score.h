// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clusters/cluster_track.h"

namespace cvo {

// How sure it is that a body is where the cluster says in frame `newest`, in (0, 1), to rank
// estimates (METHOD.md 10.1). `view` is null in a frame without images.
double ScoreOf(const Options& options, const FrameView* view, FrameId newest,
               const Cluster& cluster);

}  // namespace cvo
