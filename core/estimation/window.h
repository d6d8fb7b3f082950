// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/estimation/landmark.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/window_prior.h"

namespace cvo {

struct WindowFrame {
  FrameId id;
  RigidTransform world_from_camera;
  bool is_given = false;  // the pose is held as it is (GivenKnowledge)
};

// The estimator's state of the static world: frames T_s (spatial track, sparse and old) and T_t
// (temporal track, the latest ones), and the landmarks they see (section 3.3 of the paper).
// Landmarks are sorted by id.
struct Window {
  StereoCamera camera;  // as calibrated, right_field_px as estimated so far
  WindowPrior prior;
  std::vector<WindowFrame> spatial;   // oldest first
  std::vector<WindowFrame> temporal;  // oldest first
  std::vector<Landmark> landmarks;

  std::vector<const WindowFrame*> Frames() const;  // T_s then T_t, oldest first
  const WindowFrame* Find(FrameId id) const;       // null where the frame is not in the window
  // Landmarks with an observation in both frames.
  int CountCommonLandmarks(FrameId a, FrameId b) const;
  int CountLandmarks(FrameId frame) const;
  // Median distance along the optical axis of the landmarks seen in the frame; 0 where it sees
  // none.
  double MedianDepth(FrameId frame) const;

  void RemoveObservations(FrameId frame);
  // Landmarks without observations go.
  void RemoveUnobserved();
};

}  // namespace cvo
