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

// Gives one option its default.
template <auto kGroup, auto kField>
void Default(Options& options) {
  options.*kGroup.*kField = Options().*kGroup.*kField;
}

// One of our additions to Paper: policies (PaperWith), options that get their defaults, or both.
struct Rung {
  std::string_view name;
  std::string_view adds;
  void (*set)(Options&) = [](Options&) {};
};

// The ladder from Paper to Full, in the order of the paper's sections. All rungs together make
// Full: all.h asserts this for the axes, a test for the options.
inline constexpr Rung kLadder[] = {
    {"boxes",
     "bounded weights of landmarks in boxes, a share of each box for every cluster, no votes for "
     "boxes of another class, no limit of the entropy",
     Default<&Options::association, &ClusterAssociationOptions::max_entropy>},
    {"left_image", "landmarks of bodies are also found if only the left image shows them",
     Default<&Options::association, &ClusterAssociationOptions::left_only>},
    {"missed_detections", "a missed detection is no evidence against a cluster",
     Default<&Options::unary, &UnaryOptions::undetected_reach>},
    {"box_size", "a cluster fills its box",
     Default<&Options::clusters, &ClusterOptions::box_half_size>},
    {"new_bodies", "a new body is the nearest dense range of depths that fills its box"},
    {"reserve", "bodies get additional corners", Default<&Options::orb, &OrbOptions::reserve>},
    {"confirmation",
     "a cluster is reported from its second detection on, and archived if neither boxes nor motion "
     "show it any more",
     [](Options& options) {
       Default<&Options::clusters, &ClusterOptions::confirm_detections>(options);
       Default<&Options::clusters, &ClusterOptions::undetected_frames>(options);
     }},
    {"aligned_patches", "matched corners are aligned with the first patch of their landmark",
     Default<&Options::tracking, &TrackingOptions::align_patches>},
    {"promotion",
     "a frame joins the spatial track if it is far from the newest one there, or turned"},
    {"patch_noise",
     "the noise of a disparity grows with the disagreement of the quarters of its patch",
     Default<&Options::noise, &NoiseOptions::disagreement>},
    {"self_calibration",
     "the calibration's error is estimated: that of columns with the window, as a field over the "
     "image, that of rows from each pair of images",
     [](Options& options) {
       Default<&Options::noise, &NoiseOptions::right_mean_px>(options);
       Default<&Options::stereo, &StereoMatchOptions::max_row_correction_px>(options);
     }},
    {"outlier_removal", "observations beyond the gate are removed after each solution"},
    {"body_motion",
     "the motion prior has 1 m^2/s^3 instead of 0.01 m^2/frame^3 and includes orientations; "
     "predicted bodies keep turning"},
    {"past_information", "observations that leave the window stay in their landmarks",
     Default<&Options::clusters, &ClusterOptions::max_past_observations>},
    {"trace_back", "new clusters are also searched for in earlier frames",
     Default<&Options::clusters, &ClusterOptions::trace_states>},
    {"relaunch",
     "a lost cluster is kept for 45 frames, and is relaunched in its box only while its prediction "
     "is good",
     Default<&Options::clusters, &ClusterOptions::live_frames>}};
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
      std::conditional_t<HasRung(kSet, "relaunch"), Full::BoxRematch, Paper::BoxRematch>;

  static void SetDefaults(Options& options) {
    Paper::SetDefaults(options);
    for (std::size_t i = 0; i < kRungs; ++i) {
      if ((kSet >> i & 1U) != 0) kLadder[i].set(options);
    }
  }
};

}  // namespace cvo
