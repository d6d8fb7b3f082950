// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "core/base/error.h"
#include "variants/full.h"
#include "variants/paper.h"

namespace cvo {

// Each rung adds one of our additions to a variant between Paper and Full: a policy, options
// that get their defaults, or both.
template <typename Base>
struct AddBoundedBoxes : Base {
  static constexpr std::string_view kRung = "boxes";
  static constexpr std::string_view kAdds =
      "bounded weights of landmarks in boxes, a share of each box for every cluster, no boxes of "
      "another class";
  using Boxes = BoundedBoxes;
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
struct AddBoxSize : Base {
  static constexpr std::string_view kRung = "box_size";
  static constexpr std::string_view kAdds = "a cluster fills its box";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.box_half_size = Options().clusters.box_half_size;
  }
};

template <typename Base>
struct AddBodiesByDepth : Base {
  static constexpr std::string_view kRung = "new_bodies";
  static constexpr std::string_view kAdds =
      "a new body is the nearest dense range of depths that fills its box, no part of another, "
      "with its origin behind the surface";
  using NewBody = BodiesByDepth;
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.extent.part_share = Options().extent.part_share;
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
struct AddConfirmation : Base {
  static constexpr std::string_view kRung = "confirmation";
  static constexpr std::string_view kAdds = "a cluster is reported from its second detection on";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.confirm_detections = Options().clusters.confirm_detections;
  }
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
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.noise.right_mean_px = Options().noise.right_mean_px;
    options.stereo.max_row_correction_px = Options().stereo.max_row_correction_px;
  }
};

template <typename Base>
struct AddPromotion : Base {
  static constexpr std::string_view kRung = "promotion";
  static constexpr std::string_view kAdds =
      "a frame joins the spatial track if it is far from the newest one there, or turned";
  using Frames = DoubleTrackFrames;
};

template <typename Base>
struct AddOutlierRemoval : Base {
  static constexpr std::string_view kRung = "outlier_removal";
  static constexpr std::string_view kAdds =
      "observations beyond the gate are removed after each solution";
  using Outliers = RemoveOutliers;
};

template <typename Base>
struct AddBodyMotion : Base {
  static constexpr std::string_view kRung = "body_motion";
  static constexpr std::string_view kAdds =
      "the motion prior has 1 m^2/s^3 instead of 0.01 m^2/frame^3 and includes orientations; "
      "predicted bodies keep turning";
  using BodyMotion = WhiteNoiseMotion;
};

template <typename Base>
struct AddPastInformation : Base {
  static constexpr std::string_view kRung = "past_information";
  static constexpr std::string_view kAdds =
      "observations that leave the window stay in their landmarks";
  static void SetDefaults(Options& options) {
    Base::SetDefaults(options);
    options.clusters.max_past_observations = Options().clusters.max_past_observations;
  }
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
      "a cluster that is not found releases its box; a new cluster that shares landmarks with a "
      "lost one takes over its id and its body frame";
  using BoxRematch = RematchInBox;
  using Identity = InheritLostIdentity;
};

// The ladder from Paper to Full, one addition at a time, in the order of the paper's sections.
// All rungs together make Full: all.h asserts this for the axes, a test for the options.
template <template <typename> class R>
struct Rung {
  template <typename Base>
  using On = R<Base>;
  static constexpr std::string_view kName = R<Paper>::kRung;
  static constexpr std::string_view kAdds = R<Paper>::kAdds;
};
using Rungs =
    std::tuple<Rung<AddBoundedBoxes>, Rung<AddLeftImage>, Rung<AddMissedDetections>,
               Rung<AddBoxSize>, Rung<AddBodiesByDepth>, Rung<AddReserve>, Rung<AddConfirmation>,
               Rung<AddAlignedPatches>, Rung<AddPromotion>, Rung<AddPatchNoise>,
               Rung<AddSelfCalibration>, Rung<AddOutlierRemoval>, Rung<AddBodyMotion>,
               Rung<AddPastInformation>, Rung<AddTraceBack>, Rung<AddIdentity>>;
inline constexpr std::size_t kRungs = std::tuple_size_v<Rungs>;

namespace internal {

// Paper with the first kCount rungs, except for rung kLeftOut.
template <std::size_t kCount, std::size_t kLeftOut>
struct PaperWith {
  using Below = typename PaperWith<kCount - 1, kLeftOut>::Type;
  using Type =
      std::conditional_t<kCount - 1 == kLeftOut, Below,
                         typename std::tuple_element_t<kCount - 1, Rungs>::template On<Below>>;
};
template <std::size_t kLeftOut>
struct PaperWith<0, kLeftOut> {
  using Type = Paper;
};

}  // namespace internal

// Paper with all rungs up to and including rung kRung.
template <std::size_t kRung>
struct UpTo : internal::PaperWith<kRung + 1, kRungs>::Type {
  using Added = std::tuple_element_t<kRung, Rungs>;
  static std::string Name() { return StrCat("paper_to_", Added::kName); }
  static std::string Changes() {
    return StrCat("paper with the additions of the ladder up to and including: ", Added::kAdds);
  }
};

// Full without rung kRung.
template <std::size_t kRung>
struct Without : internal::PaperWith<kRungs, kRung>::Type {
  using Left = std::tuple_element_t<kRung, Rungs>;
  static std::string Name() { return StrCat("no_", Left::kName); }
  static std::string Changes() { return StrCat("full without this addition: ", Left::kAdds); }
};

}  // namespace cvo
