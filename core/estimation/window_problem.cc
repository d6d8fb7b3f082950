// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/window_problem.h"

#include <algorithm>

namespace cvo {

WindowProblem MakeFrames(const Window& window) {
  WindowProblem problem;
  problem.camera = window.camera;
  problem.prior = window.prior;
  for (const WindowFrame* frame : window.Frames()) {
    problem.frames.push_back(frame->id);
    problem.world_from_camera.push_back(frame->world_from_camera);
  }
  problem.is_fixed.assign(problem.frames.size(), 0);
  return problem;
}

void AddLandmark(const Landmark& landmark, const FeatureNoise& noise, WindowProblem& problem) {
  const int point = static_cast<int>(problem.points.size());
  problem.points.push_back(landmark.p_in_object);
  for (const Observation& observation : landmark.observations) {
    problem.factors.push_back({FrameIndex(problem, observation.frame), point, observation.z_px,
                               noise.SqrtInformation(observation)});
  }
}

std::vector<int> SelectLandmarks(const Window& window, int max_points) {
  std::vector<int> selected;
  for (int i = 0; i < static_cast<int>(window.landmarks.size()); ++i) {
    if (window.landmarks[i].observations.size() >= 2) selected.push_back(i);
  }
  if (static_cast<int>(selected.size()) > max_points) {
    std::stable_sort(selected.begin(), selected.end(), [&](int a, int b) {
      return window.landmarks[a].observations.size() > window.landmarks[b].observations.size();
    });
    selected.resize(static_cast<std::size_t>(max_points));
    std::sort(selected.begin(), selected.end());
  }
  return selected;
}

}  // namespace cvo
