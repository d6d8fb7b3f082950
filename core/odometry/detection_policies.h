// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/interface/frame.h"

namespace cvo {

// Selects the detections, and the given knowledge of bodies, that the estimator is shown.
template <typename Policy>
concept DetectionPolicy = requires(const StereoFrame& frame) {
  { Policy::Show(frame) } -> std::same_as<ShownBodies>;
};

// Policy: all those of the frame.
struct UseDetections {
  static ShownBodies Show(const StereoFrame& frame) {
    return {frame.detections, frame.given.feature_body, frame.given.detection_body};
  }
  static ShownBodies Show(StereoFrame&&) = delete;  // the views would outlive the frame
};
// Policy: none. No cluster is ever found, and the world is assumed to be static.
struct IgnoreDetections {
  static ShownBodies Show(const StereoFrame&) { return {}; }
};

}  // namespace cvo
