// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/estimation/cluster.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/window_solver.h"

namespace cvo {

struct WindowFrame {
  FrameId id;
  RigidTransform world_from_camera;
  bool is_given = false;  // the pose is held fixed (GivenKnowledge)
};

// Estimator state of the static world: the frames of T_s (spatial track: old and sparse) and of T_t
// (temporal track: the most recent ones), and the landmarks that they see (section 3.3 of the
// paper). Landmarks are sorted by id.
struct Window {
  StereoCamera camera;  // as calibrated, but with the current estimate of right_field_px
  WindowPrior prior;
  std::vector<WindowFrame> spatial;   // oldest first
  std::vector<WindowFrame> temporal;  // oldest first
  std::vector<Landmark> landmarks;

  std::vector<const WindowFrame*> Frames() const;  // T_s then T_t, oldest first
  const WindowFrame* Find(FrameId id) const;       // null if the frame is not in the window
  // Number of landmarks observed in both frames.
  int CountCommonLandmarks(FrameId a, FrameId b) const;
  int CountLandmarks(FrameId frame) const;
  // Median depth of the landmarks seen in the frame; 0 if it sees none.
  double MedianDepth(FrameId frame) const;

  void RemoveObservations(FrameId frame);
  // Removes landmarks that have no observations.
  void RemoveUnobserved();
};

}  // namespace cvo
