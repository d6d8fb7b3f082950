// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/full.h"

namespace cvo {

// Each rung adds one of our additions to a variant between ClusterVo and Full: a policy, options
// that get their defaults, or both (ladder.h).
template <typename Base>
struct AddBoxWeights : Base {
  static constexpr std::string_view kRung = "box_weights";
  static constexpr std::string_view kAdds =
      "bounded weights of landmarks in boxes, and a cluster may have no box";
  using BoxWeights = BoundedBoxWeights;
};

template <typename Base>
struct AddEntropyInNats : Base {
  static constexpr std::string_view kRung = "entropy";
  static constexpr std::string_view kAdds = "an entropy limit of 1 nat instead of 1 bit for boxes";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.association.max_entropy = Options().association.max_entropy;
  }
};

template <typename Base>
struct AddBoxShare : Base {
  static constexpr std::string_view kRung = "box_share";
  static constexpr std::string_view kAdds =
      "clusters inside one box compete by their share of its weight";
  using BoxCost = SharedBoxCost;
};

template <typename Base>
struct AddLeastShare : Base {
  static constexpr std::string_view kRung = "least_share";
  static constexpr std::string_view kAdds =
      "a box is assigned only if it contains a minimum share and number of the cluster's landmarks";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.association.min_box_probability = Options().association.min_box_probability;
    options.association.min_box_members = Options().association.min_box_members;
  }
};

template <typename Base>
struct AddClassGate : Base {
  static constexpr std::string_view kRung = "class_gate";
  static constexpr std::string_view kAdds = "a cluster takes no box of another class";
  using ClassGate = RefuseOtherClasses;
};

template <typename Base>
struct AddWideGate : Base {
  static constexpr std::string_view kRung = "wide_gate";
  static constexpr std::string_view kAdds = "a 95 % gate for features instead of 74 %";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.association.gamma = Options().association.gamma;
  }
};

template <typename Base>
struct AddTurning : Base {
  static constexpr std::string_view kRung = "turning";
  static constexpr std::string_view kAdds = "bodies are predicted to keep turning";
  using Rotation = ConstantAngularVelocity;
};

template <typename Base>
struct AddViewGate : Base {
  static constexpr std::string_view kRung = "view_gate";
  static constexpr std::string_view kAdds = "landmarks are not searched on the far side of a body";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.association.max_view_change_rad = Options().association.max_view_change_rad;
  }
};

template <typename Base>
struct AddReacquisition : Base {
  static constexpr std::string_view kRung = "reacquisition";
  static constexpr std::string_view kAdds =
      "boxes without a cluster are tried on clusters that were not found";
  using BoxRematch = RematchInBox;
};

template <typename Base>
struct AddLeftImage : Base {
  static constexpr std::string_view kRung = "left_image";
  static constexpr std::string_view kAdds =
      "landmarks of bodies are also found if only the left image shows them";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.association.left_only = Options().association.left_only;
  }
};

template <typename Base>
struct AddMissedDetections : Base {
  static constexpr std::string_view kRung = "missed_detections";
  static constexpr std::string_view kAdds = "a missed detection is no evidence against a cluster";
  using BoxTerm = Box2dTerm;
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.unary.undetected_reach = Options().unary.undetected_reach;
  }
};

template <typename Base>
struct AddBoxFoot : Base {
  static constexpr std::string_view kRung = "box_foot";
  static constexpr std::string_view kAdds = "the foot of a box may show the ground";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.unary.box_foot = Options().unary.box_foot;
  }
};

template <typename Base>
struct AddBoxShrink : Base {
  static constexpr std::string_view kRung = "box_shrink";
  static constexpr std::string_view kAdds = "the border of a box is taken for background";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.unary.box_shrink = Options().unary.box_shrink;
  }
};

template <typename Base>
struct AddCheapStatic : Base {
  static constexpr std::string_view kRung = "static_energy";
  static constexpr std::string_view kAdds =
      "the static class costs 1 nat in the affinity term, not 2";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.unary.static_energy = Options().unary.static_energy;
  }
};

template <typename Base>
struct AddBoxSize : Base {
  static constexpr std::string_view kRung = "box_size";
  static constexpr std::string_view kAdds = "a cluster fills its box";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.box_half_size = Options().clusters.box_half_size;
  }
};

template <typename Base>
struct AddNearestDepths : Base {
  static constexpr std::string_view kRung = "nearest_depths";
  static constexpr std::string_view kAdds =
      "a new body is the nearest dense range of depths that fills its box, and no part of another";
  using NewBody = NearestDepths;
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.extent.part_share = Options().extent.part_share;
  }
};

template <typename Base>
struct AddTriangulation : Base {
  static constexpr std::string_view kRung = "triangulation";
  static constexpr std::string_view kAdds =
      "current triangulations instead of landmarks in the motion and pairwise terms";
  using PointPlace = TriangulatedPlace;
};

template <typename Base>
struct AddLongPast : Base {
  static constexpr std::string_view kRung = "long_past";
  static constexpr std::string_view kAdds =
      "the motion term looks up to 14 frames back, less for new landmarks";
  using PastFrame = OldestPastFrame;
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.unary.past_frames = Options().unary.past_frames;
  }
};

template <typename Base>
struct AddReserve : Base {
  static constexpr std::string_view kRung = "reserve";
  static constexpr std::string_view kAdds = "bodies get additional corners";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.orb.reserve = Options().orb.reserve;
  }
};

template <typename Base>
struct AddBirthOrigin : Base {
  static constexpr std::string_view kRung = "birth_origin";
  static constexpr std::string_view kAdds =
      "a body's origin lies behind its surface, on the ray through its box";
  using BirthOrigin = OriginBehindBox;
};

template <typename Base>
struct AddConfirmation : Base {
  static constexpr std::string_view kRung = "confirmation";
  static constexpr std::string_view kAdds = "a cluster is reported from its second detection on";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.confirm_detections = Options().clusters.confirm_detections;
  }
};

template <typename Base>
struct AddArchiveUndetected : Base {
  static constexpr std::string_view kRung = "archive_undetected";
  static constexpr std::string_view kAdds =
      "a cluster that stands still and is no longer detected is archived";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.undetected_frames = Options().clusters.undetected_frames;
  }
};

template <typename Base>
struct AddFixedGauge : Base {
  static constexpr std::string_view kRung = "fixed_gauge";
  static constexpr std::string_view kAdds = "the oldest frame of the window is held fixed";
  using Gauge = FixOldestFrame;
};

template <typename Base>
struct AddAlignedPatches : Base {
  static constexpr std::string_view kRung = "aligned_patches";
  static constexpr std::string_view kAdds =
      "matched corners are aligned with the first patch of their landmark";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.tracking.align_patches = Options().tracking.align_patches;
  }
};

template <typename Base>
struct AddPatchNoise : Base {
  static constexpr std::string_view kRung = "patch_noise";
  static constexpr std::string_view kAdds =
      "the noise of a disparity grows with the disagreement of the quarters of its patch";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.noise.disagreement = Options().noise.disagreement;
  }
};

template <typename Base>
struct AddSelfCalibration : Base {
  static constexpr std::string_view kRung = "self_calibration";
  static constexpr std::string_view kAdds =
      "the calibration's error is estimated: that of columns with the window, as a field over the "
      "image, that of rows from each pair of images";
  using Calibration = EstimateRightField;
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.stereo.max_row_correction_px = Options().stereo.max_row_correction_px;
  }
};

template <typename Base>
struct AddOutlierRemoval : Base {
  static constexpr std::string_view kRung = "outlier_removal";
  static constexpr std::string_view kAdds =
      "observations beyond the gate are removed after each solution";
  using Outliers = RemoveOutliers;
};

template <typename Base>
struct AddEarlyStop : Base {
  static constexpr std::string_view kRung = "early_stop";
  static constexpr std::string_view kAdds = "solvers stop early, near one step per frame";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.solver.iterations = Options().solver.iterations;
    options.solver.function_tolerance = Options().solver.function_tolerance;
  }
};

template <typename Base>
struct AddStifferPrior : Base {
  static constexpr std::string_view kRung = "stiffer_prior";
  static constexpr std::string_view kAdds =
      "the motion prior has 1 m^2/s^3 instead of 0.01 m^2/frame^3";
  using MotionPrior = WhiteNoiseOnTranslation;
};

template <typename Base>
struct AddTurnPrior : Base {
  static constexpr std::string_view kRung = "turn_prior";
  static constexpr std::string_view kAdds = "a motion prior on orientations";
  using MotionPrior = WithTurnPrior<typename Base::MotionPrior>;
};

template <typename Base>
struct AddPastInformation : Base {
  static constexpr std::string_view kRung = "past_information";
  static constexpr std::string_view kAdds =
      "observations that leave the window stay in their landmarks";
  using Past = KeepPastInformation;
};

template <typename Base>
struct AddTraceBack : Base {
  static constexpr std::string_view kRung = "trace_back";
  static constexpr std::string_view kAdds = "new clusters are also searched for in earlier frames";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.trace_states = Options().clusters.trace_states;
  }
};

template <typename Base>
struct AddIdentity : Base {
  static constexpr std::string_view kRung = "identity";
  static constexpr std::string_view kAdds =
      "a new cluster explained by exactly one lost cluster takes over its id";
  using Identity = InheritLostIdentity;
};

template <typename Base>
struct AddAlignment : Base {
  static constexpr std::string_view kRung = "alignment";
  static constexpr std::string_view kAdds =
      "when an id is inherited, the new object frame is aligned with the old one";
  using Identity = WithAlignedFrames<typename Base::Identity>;
};

}  // namespace cvo
