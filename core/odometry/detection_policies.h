// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/interface/frame.h"

namespace cvo {

// Which detections, and what given knowledge of bodies, the estimator is shown.
template <typename Policy>
concept DetectionPolicy = requires(const StereoFrame& frame) {
  { Policy::Show(frame) } -> std::same_as<ShownBodies>;
};

// Policy: all of the frame's.
struct UseDetections {
  static ShownBodies Show(const StereoFrame& frame) {
    return {frame.detections, frame.given.feature_body, frame.given.detection_body};
  }
  static ShownBodies Show(StereoFrame&&) = delete;  // the views would outlive the frame
};
// Policy: none; no cluster is ever found, the world is taken for static.
struct IgnoreDetections {
  static ShownBodies Show(const StereoFrame&) { return {}; }
};

}  // namespace cvo
