// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/full.h"
#include "variants/paper.h"

namespace cvo {

struct CeresSolver;  // core/ceres/ceres_solvers.h

// Each variant removes something from Full; all.h asserts the number of axes that differ.
struct Only2d : Full {
  static constexpr std::string_view kName = "2d";
  static constexpr std::string_view kChanges =
      "labels from the 2D boxes only: no 3D affinity, no motion term";
  using AffinityTerm = NoTerm;
  using MotionTerm = NoTerm;
};

struct Only2d3d : Full {
  static constexpr std::string_view kName = "2d3d";
  static constexpr std::string_view kChanges =
      "labels from 2D boxes and 3D affinity: no motion term";
  using MotionTerm = NoTerm;
};

struct NoGpPrior : Full {
  static constexpr std::string_view kName = "no_gp_prior";
  static constexpr std::string_view kChanges =
      "without the paper's white-noise-on-acceleration prior on positions; the prior on "
      "orientations is kept";
  using BodyMotion = TurnNoiseMotion;
};

struct NoTurnPrior : Full {
  static constexpr std::string_view kName = "no_turn_prior";
  static constexpr std::string_view kChanges = "without the motion prior on orientations";
  using BodyMotion = TranslationNoiseMotion;
};

struct WithoutMotionPrior : Full {
  static constexpr std::string_view kName = "no_motion_prior";
  static constexpr std::string_view kChanges =
      "no motion prior at all: each pose of a cluster is estimated independently";
  using BodyMotion = FreeMotion;
};

struct NoPairwiseTerm : Full {
  static constexpr std::string_view kName = "no_pairwise";
  static constexpr std::string_view kChanges =
      "no pairwise term: each label is inferred independently";
  using Pairwise = NoPairwise;
};

struct NoProbabilisticAssociation : Full {
  static constexpr std::string_view kName = "no_probabilistic_association";
  static constexpr std::string_view kChanges =
      "features of clusters are searched within a fixed radius";
  using LandmarkAssociation = FixedRadiusAssociation;
};

struct WithoutBoxRematch : Full {
  static constexpr std::string_view kName = "no_box_rematch";
  static constexpr std::string_view kChanges =
      "no brute-force matching inside boxes: landmarks are matched only by prediction";
  using BoxRematch = NoBoxRematch;
};

struct NoMarginalization : Full {
  static constexpr std::string_view kName = "no_marginalization";
  static constexpr std::string_view kChanges =
      "frames leaving the spatial track are dropped without a prior";
  using Frames = DroppedFrames;
};

struct NoSpatialTrack : Full {
  static constexpr std::string_view kName = "no_spatial_track";
  static constexpr std::string_view kChanges =
      "frames leaving the temporal track are always discarded";
  using Frames = TemporalFrames;
};

struct NoLabelConfidence : Full {
  static constexpr std::string_view kName = "no_label_confidence";
  static constexpr std::string_view kChanges =
      "the inferred labels of each frame are adopted immediately";
  using Confidence = TakeLabelsAtOnce;
};

struct Static : Full {
  static constexpr std::string_view kName = "static";
  static constexpr std::string_view kChanges = "no clusters: the static-world baseline";
  using Detections = IgnoreDetections;
};

// What others do, as far as one policy can tell.
struct FrameToFrame : Static {
  static constexpr std::string_view kName = "frame_to_frame";
  static constexpr std::string_view kChanges =
      "static; a window of two frames, and the calibration is trusted: libviso2's kind";
  using Frames = TemporalFrames;
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.window.temporal = 2;
    options.stereo.max_row_correction_px = 0.0;
    options.noise.right_mean_px = 0.0;
  }
};

struct MaskStatic : Static {
  static constexpr std::string_view kName = "mask_static";
  static constexpr std::string_view kChanges =
      "static; features inside boxes are left out: DynaSLAM's camera";
  using Detections = MaskDetections;
};

struct Boxes3d : Only2d {
  static constexpr std::string_view kName = "boxes_3d";
  static constexpr std::string_view kChanges =
      "2d; no pairwise term: a body is what its box holds, without clustering";
  using Pairwise = NoPairwise;
};

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

struct StaticShiftOnly : Static {
  static constexpr std::string_view kName = "static_shift_only";
  static constexpr std::string_view kChanges =
      "static; the calibration error is estimated as one constant over the image";
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.noise.right_field_px = 0.0;
  }
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
  static void SetDefaults(Options& options) {
    Static::SetDefaults(options);
    options.stereo.max_row_correction_px = 0.0;
    options.noise.right_mean_px = 0.0;
  }
};

// Each variant solves its windows with the Ceres library and is otherwise the same as OwnSolver.
// They are in builds with Ceres alone (CVO_CERES).
struct FullCeres : Full {
  using OwnSolver = Full;
  static constexpr std::string_view kName = "full_ceres";
  static constexpr std::string_view kChanges = "full; windows are solved by Ceres";
  using Solver = CeresSolver;
};

struct PaperCeres : Paper {
  using OwnSolver = Paper;
  static constexpr std::string_view kName = "paper_ceres";
  static constexpr std::string_view kChanges = "paper; windows are solved by Ceres";
  using Solver = CeresSolver;
};

struct StaticCeres : Static {
  using OwnSolver = Static;
  static constexpr std::string_view kName = "static_ceres";
  static constexpr std::string_view kChanges = "static; windows are solved by Ceres";
  using Solver = CeresSolver;
};

}  // namespace cvo
