// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clustering/crf_scene.h"
#include "core/labelling/frame_points.h"

namespace cvo {

// The classes of the CRF in one frame, M = N1 + N2 + 1: the static scene and the live clusters,
// detections that belong to none of them, and the outlier class last.
struct LabelScene {
  CrfScene crf;                    // nodes by point
  std::vector<int> detection;      // by label: a new box's detection; -1 for the others
  std::vector<BodyId> given_body;  // by label, as GivenKnowledge says; invalid: unknown
  int clusters = 0;                // labels 1 ... clusters are map.live[0], ...

  int Outlier() const { return static_cast<int>(crf.labels.size()) - 1; }
  bool IsNewBox(int label) const { return label > clusters && label < Outlier(); }
};

// What is known of every point and every class (section 3.2 of the paper). The current frame is
// the one after the window's newest.
LabelScene BuildLabelScene(const FrameView& view, const Window& window, const ClusterMap& map,
                           const std::vector<ClusterTrack>& tracks,
                           const std::vector<FramePoint>& points);

}  // namespace cvo
