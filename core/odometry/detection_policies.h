// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/odometry/frame.h"

namespace cvo {

// Which detections the estimator is shown. Policy: all of the frame's.
struct UseDetections {
  static const std::vector<Detection>& Shown(const StereoFrame& frame) { return frame.detections; }
};
// Policy: none; no cluster is ever found, the world is taken for static.
struct IgnoreDetections {
  static std::vector<Detection> Shown(const StereoFrame&) { return {}; }
};

}  // namespace cvo
