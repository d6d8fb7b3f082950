// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/interface/frame.h"

namespace cvo {

// Which detections, and what given knowledge of bodies, the estimator is shown. Policy: all of the
// frame's.
struct UseDetections {
  static const std::vector<Detection>& Shown(const StereoFrame& frame) { return frame.detections; }
  static const GivenKnowledge& Given(const StereoFrame& frame) { return frame.given; }
};
// Policy: none; no cluster is ever found, the world is taken for static.
struct IgnoreDetections {
  static std::vector<Detection> Shown(const StereoFrame&) { return {}; }
  static GivenKnowledge Given(const StereoFrame&) { return {}; }
};

}  // namespace cvo
