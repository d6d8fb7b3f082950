// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/full.h"

namespace cvo {

// The method of the paper as its authors must have meant it: the printed equations with the
// corrections of METHOD.md 9 that they need to work, the paper's numbers, and nothing of ours.
struct ClusterVo {
  static constexpr std::string_view kName = "clustervo";
  static constexpr std::string_view kChanges =
      "the method of the paper, with only the corrections that its equations need (METHOD.md 9)";
  using Detections = UseDetections;
  // Section 3.1.
  using LandmarkAssociation = ProbabilisticAssociation;
  using Boxes = PrintedBoxWeights;
  using BoxRematch = RematchInOwnBox;
  using Identity = AlwaysNewIdentity;
  // Section 3.2.
  using BoxTerm = DetectedBox2dTerm;
  using AffinityTerm = cvo::AffinityTerm;
  using MotionTerm = cvo::MotionTerm;
  using MotionEvidence = EstimateAndPast;
  using NewBody = BodiesOfAllPoints;
  using Pairwise = NormalizedGaussianKernel;
  using Confidence = CountLabels;
  // Section 3.3.
  using BodyMotion = FrameNoiseMotion;
  using Past = ForgetPast;
  using Outliers = KeepOutliers;
  using Frames = DoubleTrackFrames;
  using Calibration = TrustCalibration;
  using Solver = OwnSchur;

  // Sets the values that the paper prints and, for options that it does not have, those that switch
  // our additions off.
  static void SetDefaults(Options& options) {
    options.association.left_only = false;
    options.clusters.trace_states = 0;
    options.unary.past_frames = 5;
    options.unary.undetected_reach = 0.0;
    options.clusters.box_half_size = 0.0;
    options.clusters.confirm_detections = 1;
    options.orb.reserve = 0.0;
    options.stereo.max_row_correction_px = 0.0;
    options.extent.part_share = 2.0;
    options.tracking.align_patches = false;
    options.noise.disagreement = 0.0;
    options.solver.iterations = 10;
    options.solver.function_tolerance = 1e-6;
  }
};

}  // namespace cvo
