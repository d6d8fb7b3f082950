// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/labelling/cluster_labels.h"

namespace cvo {

// Creates the clusters that are born from the frame's labels. They are at rest, their axes are the
// principal axes of their points, and they have no landmarks yet.
void CreateClusters(const FrameView& view, FrameId newest, const std::vector<FramePoint>& points,
                    const FrameLabels& labels, ClusterMap& map);

// Adds the observation and label of every landmark seen in the frame `entering`. A landmark whose
// label changes moves to its new body, together with the observations that agree with that body's
// motion; one that is assigned to no body is removed. Features without a landmark become landmarks,
// with ids from next_id on. A cluster without a pose in the frame receives no landmarks. Writes the
// ids of the landmarks to `labels` and returns the number of new landmarks.
int UpdateLandmarks(const FrameView& view, const WindowFrame& entering,
                    const std::vector<ClusterTrack>& tracks, const std::vector<FramePoint>& points,
                    FrameLabels& labels, LandmarkId& next_id, Window& window, ClusterMap& map);

// Removes landmarks that have one observation, no past information, and were not seen in the last
// three frames.
void RemoveUnconfirmed(FrameId newest, std::vector<Landmark>& landmarks);

}  // namespace cvo
