// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "core/base/error.h"
#include "variants/full.h"
#include "variants/paper.h"

namespace cvo {

// One of our additions to Paper: policies (PaperWith), options that get their defaults, or both.
struct Rung {
  std::string_view name;
  std::string_view adds;
  void (*set)(Options& options, const Options& ours) = [](Options&, const Options&) {};
};

// The ladder from Paper to Full, in the order of the paper's sections. All rungs together make
// Full: all.h asserts this for the axes, a test for the options.
inline constexpr Rung kLadder[] = {
    {"boxes",
     "bounded weights of landmarks in boxes, a share of each box for every cluster, no boxes of "
     "another class"},
    {"left_image", "landmarks of bodies are also found if only the left image shows them",
     [](Options& options, const Options& ours) {
       options.association.left_only = ours.association.left_only;
     }},
    {"missed_detections", "a missed detection is no evidence against a cluster",
     [](Options& options, const Options& ours) {
       options.unary.undetected_reach = ours.unary.undetected_reach;
     }},
    {"box_size", "a cluster fills its box",
     [](Options& options, const Options& ours) {
       options.clusters.box_half_size = ours.clusters.box_half_size;
     }},
    {"new_bodies",
     "a new body is the nearest dense range of depths that fills its box, no part of another, "
     "with its origin behind the surface",
     [](Options& options, const Options& ours) {
       options.extent.part_share = ours.extent.part_share;
     }},
    {"reserve", "bodies get additional corners",
     [](Options& options, const Options& ours) { options.orb.reserve = ours.orb.reserve; }},
    {"confirmation",
     "a cluster is reported from its second detection on, and archived if neither boxes nor motion "
     "show it any more",
     [](Options& options, const Options& ours) {
       options.clusters.confirm_detections = ours.clusters.confirm_detections;
       options.clusters.undetected_frames = ours.clusters.undetected_frames;
     }},
    {"aligned_patches", "matched corners are aligned with the first patch of their landmark",
     [](Options& options, const Options& ours) {
       options.tracking.align_patches = ours.tracking.align_patches;
     }},
    {"promotion",
     "a frame joins the spatial track if it is far from the newest one there, or turned"},
    {"patch_noise",
     "the noise of a disparity grows with the disagreement of the quarters of its patch",
     [](Options& options, const Options& ours) {
       options.noise.disagreement = ours.noise.disagreement;
     }},
    {"self_calibration",
     "the calibration's error is estimated: that of columns with the window, as a field over the "
     "image, that of rows from each pair of images",
     [](Options& options, const Options& ours) {
       options.noise.right_mean_px = ours.noise.right_mean_px;
       options.stereo.max_row_correction_px = ours.stereo.max_row_correction_px;
     }},
    {"outlier_removal", "observations beyond the gate are removed after each solution"},
    {"body_motion",
     "the motion prior has 1 m^2/s^3 instead of 0.01 m^2/frame^3 and includes orientations; "
     "predicted bodies keep turning"},
    {"past_information", "observations that leave the window stay in their landmarks",
     [](Options& options, const Options& ours) {
       options.clusters.max_past_observations = ours.clusters.max_past_observations;
     }},
    {"trace_back", "new clusters are also searched for in earlier frames",
     [](Options& options, const Options& ours) {
       options.clusters.trace_states = ours.clusters.trace_states;
     }},
    {"identity",
     "a cluster that is not found keeps its box only while its prediction is good; a new cluster "
     "that shares landmarks with a lost one takes over its id and its body frame"}};
inline constexpr std::size_t kRungs = std::size(kLadder);
inline constexpr std::uint32_t kAllRungs = (1U << kRungs) - 1U;

// Whether the bit of the rung is set. Does not compile for a name that is no rung.
consteval bool HasRung(std::uint32_t rungs, std::string_view name) {
  for (std::size_t i = 0; i < kRungs; ++i) {
    if (kLadder[i].name == name) return (rungs >> i & 1U) != 0;
  }
  throw Error("no such rung");
}

// Paper with the rungs of kLadder whose bits are set.
template <std::uint32_t kSet>
struct PaperWith : Paper {
  using Boxes = std::conditional_t<HasRung(kSet, "boxes"), Full::Boxes, Paper::Boxes>;
  using BoxTerm =
      std::conditional_t<HasRung(kSet, "missed_detections"), Full::BoxTerm, Paper::BoxTerm>;
  using NewBody = std::conditional_t<HasRung(kSet, "new_bodies"), Full::NewBody, Paper::NewBody>;
  using Frames = std::conditional_t<HasRung(kSet, "promotion"), Full::Frames, Paper::Frames>;
  using Outliers =
      std::conditional_t<HasRung(kSet, "outlier_removal"), Full::Outliers, Paper::Outliers>;
  using BodyMotion =
      std::conditional_t<HasRung(kSet, "body_motion"), Full::BodyMotion, Paper::BodyMotion>;
  using BoxRematch =
      std::conditional_t<HasRung(kSet, "identity"), Full::BoxRematch, Paper::BoxRematch>;
  using Identity = std::conditional_t<HasRung(kSet, "identity"), Full::Identity, Paper::Identity>;

  static void SetDefaults(Options& options) {
    Paper::SetDefaults(options);
    for (std::size_t i = 0; i < kRungs; ++i) {
      if ((kSet >> i & 1U) != 0) kLadder[i].set(options, Options());
    }
  }
};

}  // namespace cvo
