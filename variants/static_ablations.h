// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/ablations.h"

namespace cvo {

// Each variant changes one axis or option of Static; all.h asserts the number of axes.
struct StaticNoMarginalization : Static {
  static constexpr std::string_view kName = "static_no_marginalization";
  static constexpr std::string_view kChanges =
      "static; frames leaving the spatial track are dropped without a prior";
  using Frames = DroppedFrames;
};

struct StaticNoSpatialTrack : Static {
  static constexpr std::string_view kName = "static_no_spatial_track";
  static constexpr std::string_view kChanges =
      "static; frames leaving the temporal track are always discarded";
  using Frames = TemporalFrames;
};

struct StaticCornersOnly : Static {
  static constexpr std::string_view kName = "static_corners_only";
  static constexpr std::string_view kChanges =
      "static; matched corners are not aligned with the first patch of their landmark";
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.tracking.align_patches = false;
  }
};

struct StaticShiftOnly : Static {
  static constexpr std::string_view kName = "static_shift_only";
  static constexpr std::string_view kChanges =
      "static; the calibration error is estimated as one constant over the image";
  using Calibration = EstimateRightShift;
};

struct StaticNoRowEvidence : Static {
  static constexpr std::string_view kName = "static_no_row_evidence";
  static constexpr std::string_view kChanges =
      "static; the row offsets of the pair say nothing of the calibration error of its columns";
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.noise.row_field_px = 1e6;
  }
};

struct StaticTrustCalibration : Static {
  static constexpr std::string_view kName = "static_trust_calibration";
  static constexpr std::string_view kChanges =
      "static; the calibration is trusted: its error is not estimated";
  using Calibration = TrustCalibration;
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.stereo.max_row_correction_px = 0.0;
  }
};

}  // namespace cvo
