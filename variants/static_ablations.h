// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/ablations.h"

namespace cvo {

// Each changes one axis of Static; the registry counts.
struct StaticNoMarginalization : Static {
  static constexpr std::string_view kName = "static_no_marginalization";
  static constexpr std::string_view kChanges =
      "static; a frame leaving the spatial track is dropped, there is no prior";
  using MarginalizationRule = MarginalizeNothing;
};

struct StaticMarginalizeLost : Static {
  static constexpr std::string_view kName = "static_marginalize_lost";
  static constexpr std::string_view kChanges =
      "static; marginalises what the last window.lost_frames frames do not see";
  using MarginalizationRule = MarginalizeLost;
};

struct StaticPriorGauge : Static {
  static constexpr std::string_view kName = "static_prior_gauge";
  static constexpr std::string_view kChanges =
      "static; the prior alone holds the window, no frame is fixed";
  using Gauge = PriorHoldsGauge;
};

struct StaticNoSpatialTrack : Static {
  static constexpr std::string_view kName = "static_no_spatial_track";
  static constexpr std::string_view kChanges =
      "static; frames leaving the temporal track are always discarded";
  using SpatialTrack = PromoteNever;
};

struct StaticSelfCalibration : Static {
  static constexpr std::string_view kName = "static_self_calibration";
  static constexpr std::string_view kChanges =
      "static; the right camera's column shift is estimated with the window";
  using Calibration = EstimateRightShift;
};

}  // namespace cvo
