// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "core/estimation/window_policies.h"

namespace cvo {

// The static-world baseline: no clusters; moving bodies are outliers of the camera.
struct Static {
  static constexpr std::string_view kName = "static";
  static constexpr std::string_view kChanges = "no clusters: the static-world baseline";
  using MarginalizationRule = MarginalizeLost;
  using Gauge = FixOldestFrame;
  using SpatialTrack = PromoteDistant;
  using Calibration = EstimateRightShift;
};

}  // namespace cvo
