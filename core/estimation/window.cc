// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/window.h"

#include <algorithm>

namespace cvo {

const Observation* FindObservation(const Landmark& landmark, FrameId frame) {
  const auto& observations = landmark.observations;
  const auto it = std::lower_bound(observations.begin(), observations.end(), frame,
                                   [](const Observation& o, FrameId id) { return o.frame < id; });
  return it != observations.end() && it->frame == frame ? &*it : nullptr;
}

std::vector<const WindowFrame*> Window::Frames() const {
  std::vector<const WindowFrame*> frames;
  for (const WindowFrame& frame : spatial) frames.push_back(&frame);
  for (const WindowFrame& frame : temporal) frames.push_back(&frame);
  return frames;
}

const WindowFrame* Window::Find(FrameId id) const {
  for (const std::vector<WindowFrame>* track : {&spatial, &temporal}) {
    for (const WindowFrame& frame : *track) {
      if (frame.id == id) return &frame;
    }
  }
  return nullptr;
}

int Window::CountCommonLandmarks(FrameId a, FrameId b) const {
  return static_cast<int>(
      std::count_if(landmarks.begin(), landmarks.end(), [&](const Landmark& landmark) {
        return FindObservation(landmark, a) && FindObservation(landmark, b);
      }));
}

int Window::CountLandmarks(FrameId frame) const { return CountCommonLandmarks(frame, frame); }

double Window::MedianDepth(FrameId frame) const {
  const WindowFrame* seen_from = Find(frame);
  if (!seen_from) return 0.0;
  const RigidTransform camera_from_world = seen_from->world_from_camera.Inverse();
  std::vector<double> depths;
  for (const Landmark& landmark : landmarks) {
    if (FindObservation(landmark, frame)) {
      depths.push_back((camera_from_world * landmark.p_in_object).z());
    }
  }
  if (depths.empty()) return 0.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

void Window::RemoveObservations(FrameId frame) {
  for (Landmark& landmark : landmarks) {
    std::erase_if(landmark.observations, [&](const Observation& o) { return o.frame == frame; });
  }
}

void Window::RemoveUnobserved() {
  std::erase_if(landmarks, [](const Landmark& landmark) { return landmark.observations.empty(); });
}

}  // namespace cvo
