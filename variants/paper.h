// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/full.h"

namespace cvo {

// The method of the paper as its authors must have meant it: the printed equations with the
// corrections of METHOD.md 9 that they need to work, the paper's numbers, and nothing of ours.
struct Paper {
  static constexpr std::string_view kName = "paper";
  static constexpr std::string_view kChanges =
      "the method of the paper, with only the corrections that its equations need (METHOD.md 9)";
  using Detections = UseDetections;
  // Section 3.1.
  using LandmarkAssociation = ProbabilisticAssociation;
  using Boxes = PrintedBoxWeights;
  using BoxRematch = RematchAndRelaunch;
  // Section 3.2.
  using BoxTerm = DetectedBox2dTerm;
  using AffinityTerm = cvo::AffinityTerm;
  using MotionTerm = cvo::MotionTerm;
  using NewBody = BodiesOfAllPoints;
  using Pairwise = NormalizedGaussianKernel;
  using Confidence = CountLabels;
  // Section 3.3.
  using BodyMotion = FrameNoiseMotion;
  using Outliers = KeepOutliers;
  using Frames = PrintedFrames;
  using Solver = OwnSchur;

  // Sets the values that the paper prints and, for options that it does not have, those that switch
  // our additions off.
  static void SetDefaults(Options& options) {
    options.association.max_entropy = 1.0;
    options.association.left_only = false;
    options.clusters.trace_states = 0;
    options.unary.undetected_reach = 0.0;
    options.clusters.box_half_size = 0.0;
    options.clusters.confirm_detections = 1;
    options.clusters.undetected_frames = 0;
    options.clusters.live_frames = 0;
    options.orb.reserve = 0.0;
    options.stereo.max_row_correction_px = 0.0;
    options.noise.right_mean_px = 0.0;
    options.clusters.max_past_observations = 0.0;
    options.tracking.align_patches = false;
    options.noise.disagreement = 0.0;
  }
};

// The paper's ablation (its Table 4) of the paper's method; of ours, see ablations.h.
struct Paper2d : Paper {
  static constexpr std::string_view kName = "paper_2d";
  static constexpr std::string_view kChanges =
      "paper; labels from the 2D boxes only: no 3D affinity, no motion term";
  using AffinityTerm = NoTerm;
  using MotionTerm = NoTerm;
};

struct Paper2d3d : Paper {
  static constexpr std::string_view kName = "paper_2d3d";
  static constexpr std::string_view kChanges =
      "paper; labels from 2D boxes and 3D affinity: no motion term";
  using MotionTerm = NoTerm;
};

struct PaperNoMotionPrior : Paper {
  static constexpr std::string_view kName = "paper_no_motion_prior";
  static constexpr std::string_view kChanges =
      "paper; no motion prior: each pose of a cluster is estimated independently";
  using BodyMotion = FreeMotion;
};

// Each variant reverts one correction of METHOD.md 9 in Paper, to show what the equation does
// as printed.
struct PrintedGate : Paper {
  static constexpr std::string_view kName = "printed_gate";
  static constexpr std::string_view kChanges =
      "paper with equation 2 as printed: the gate uses only the covariance of the position";
  using LandmarkAssociation = ProbabilisticAssociationLiteral;
};

struct PrintedBoxes : Paper {
  static constexpr std::string_view kName = "printed_boxes";
  static constexpr std::string_view kChanges =
      "paper with equation 6 as printed: outside boxes, all classes are equally likely";
  using BoxTerm = Box2dTermLiteral;
};

struct PrintedAffinity : Paper {
  static constexpr std::string_view kName = "printed_affinity";
  static constexpr std::string_view kChanges =
      "paper with equation 7 as printed: the Mahalanobis distance over a squared length";
  using AffinityTerm = AffinityTermLiteral;
};

struct PrintedKernel : Paper {
  static constexpr std::string_view kName = "printed_kernel";
  static constexpr std::string_view kChanges =
      "paper with equation 9 as printed: the kernel is not normalised";
  using Pairwise = RawGaussianKernel;
};

}  // namespace cvo
