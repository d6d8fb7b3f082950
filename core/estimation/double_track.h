// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <vector>

#include "core/base/options.h"
#include "core/estimation/window.h"
#include "core/solvers/reprojection_cost.h"

namespace cvo {

struct WindowOptions {
  int spatial = 5;
  int temporal = 15;
  double promote_translation = 0.12;
  double promote_rotation_rad = 0.1745;
  double promote_common = 0.6;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("spatial", self.spatial,
                {"frames", 1, 100, "frames in the spatial track, |T_s|", "paper, section 4.1"});
    visit.Field("temporal", self.temporal,
                {"frames", 2, 200, "frames in the temporal track, |T_t|", "paper, section 4.1"});
    visit.Field("promote_translation", self.promote_translation,
                {"median depths", 0, 100,
                 "distance from the newest frame in T_s beyond which a frame is promoted; larger "
                 "spans more time with less overlap",
                 "METHOD.md 7.1"});
    visit.Field(
        "promote_rotation_rad", self.promote_rotation_rad,
        {"rad", 0, 3.15, "rotation from the newest frame in T_s beyond which a frame is promoted",
         "METHOD.md 7.1"});
    visit.Field("promote_common", self.promote_common,
                {"1", 0, 1,
                 "a frame is promoted if it sees less than this fraction of the landmarks of the "
                 "newest frame in T_s",
                 "METHOD.md 7.1"});
  }
};

// Decides for each landmark seen by the frame that leaves T_s whether it is marginalised with all
// its observations; otherwise only that one observation is deleted (METHOD.md 7.3). kKeepsPrior:
// what is marginalised becomes a prior of the window.
template <typename Policy>
concept MarginalizationPolicy = requires(const Landmark& landmark, FrameId newest) {
  { Policy::kKeepsPrior } -> std::convertible_to<bool>;
  { Policy::Marginalizes(landmark, newest) } -> std::same_as<bool>;
};

// Policy: marginalise landmarks that the newest frame does not see; the paper's rule.
struct MarginalizeUnseenByNewest {
  static constexpr bool kKeepsPrior = true;
  static bool Marginalizes(const Landmark& landmark, FrameId newest) {
    return landmark.last_seen < newest;
  }
};
// Policy: marginalise nothing and form no prior from what leaves.
struct MarginalizeNothing {
  static constexpr bool kKeepsPrior = false;
  static bool Marginalizes(const Landmark&, FrameId) { return false; }
};

// Whether a frame leaving T_t joins T_s.
template <typename Policy>
concept PromotionPolicy = requires(const Window& window, const WindowFrame& frame,
                                   const WindowOptions& options) {
  { Policy::Promotes(window, frame, options) } -> std::same_as<bool>;
};

// Policy: if it is far from the first frame in T_s, or has few landmarks in common with it; as
// printed.
struct PromoteFarFromFirst {
  static bool Promotes(const Window& window, const WindowFrame& frame,
                       const WindowOptions& options);
};
// Policy: if it is far from the newest frame in T_s (METHOD.md 7.1).
struct PromoteDistant {
  static bool Promotes(const Window& window, const WindowFrame& frame,
                       const WindowOptions& options);
};
// Policy: never; T_s stays empty.
struct PromoteNever {
  static bool Promotes(const Window&, const WindowFrame&, const WindowOptions&) { return false; }
};

template <typename Policy>
concept FramePolicy = MarginalizationPolicy<Policy> && PromotionPolicy<Policy>;

// Policies for frames that leave the windows: the paper's; ours; without marginalisation; without
// T_s.
struct PrintedFrames : MarginalizeUnseenByNewest, PromoteFarFromFirst {};
struct DoubleTrackFrames : MarginalizeUnseenByNewest, PromoteDistant {};
struct DroppedFrames : MarginalizeNothing, PromoteDistant {};
struct TemporalFrames : MarginalizeUnseenByNewest, PromoteNever {};

// Whether the calibration of the rig is taken as exact: right_field_px is held.
inline bool TrustsCalibration(const NoiseOptions& noise) { return noise.right_mean_px == 0.0; }
// Prior standard deviation of each coefficient of right_field_px.
Vector6d CalibrationDeviation(const NoiseOptions& noise);

// Maximum squared whitened error with which an observation stays in the window after a solve.
template <typename Policy>
concept OutlierPolicy = requires(const NoiseOptions& options) {
  { Policy::Gate(options) } -> std::same_as<double>;
};

// Policy: observations beyond noise.gate are removed permanently.
struct RemoveOutliers {
  static double Gate(const NoiseOptions& options) { return options.gate; }
};
// Policy: all observations stay, down-weighted only by the robust loss (the paper's).
struct KeepOutliers {
  static double Gate(const NoiseOptions&) { return std::numeric_limits<double>::infinity(); }
};

// Marginalises the frame, together with the given landmarks (ascending) and all their observations,
// into the window's prior. Neither the frame nor the landmarks are removed from the window.
void MarginalizeFrame(FrameId frame, const std::vector<LandmarkId>& landmarks,
                      const FeatureNoise& noise, Window& window);

// Appends `frame` to T_t. If T_t is then too long, its oldest frame is promoted to T_s or
// discarded; if T_s is then too long, its oldest frame leaves the window as Frames
// says (section 3.3 of the paper, "Double-Track Frame Management").
template <FramePolicy Frames>
class DoubleTrack {
 public:
  DoubleTrack(const WindowOptions& options, const FeatureNoise& noise)
      : options_(options), noise_(noise) {}

  void Advance(const WindowFrame& frame, Window& window) const {
    window.temporal.push_back(frame);
    if (static_cast<int>(window.temporal.size()) <= options_.temporal) return;
    const WindowFrame tail = window.temporal.front();
    if (Frames::Promotes(window, tail, options_)) {
      window.temporal.erase(window.temporal.begin());
      window.spatial.push_back(tail);
      if (static_cast<int>(window.spatial.size()) > options_.spatial) {
        RemoveSpatial(frame.id, window);
      }
    } else {
      Discard(tail.id, window);
    }
    window.RemoveUnobserved();
  }

 private:
  // The observations of a discarded frame are lost. If the prior involves the frame, it is
  // marginalised out of it.
  void Discard(FrameId frame, Window& window) const {
    if (std::binary_search(window.prior.frames.begin(), window.prior.frames.end(), frame)) {
      MarginalizeFrame(frame, {}, noise_, window);
    }
    window.temporal.erase(window.temporal.begin());
    window.RemoveObservations(frame);
  }

  void RemoveSpatial(FrameId newest, Window& window) const {
    const FrameId leaving = window.spatial.front().id;
    std::vector<LandmarkId> marginalized;
    for (const Landmark& landmark : window.landmarks) {
      if (landmark.observations.size() >= 2 && FindObservation(landmark, leaving) &&
          Frames::Marginalizes(landmark, newest)) {
        marginalized.push_back(landmark.id);
      }
    }
    if constexpr (Frames::kKeepsPrior) {
      MarginalizeFrame(leaving, marginalized, noise_, window);
    }
    std::erase_if(window.landmarks, [&](const Landmark& landmark) {
      return std::binary_search(marginalized.begin(), marginalized.end(), landmark.id);
    });
    window.spatial.erase(window.spatial.begin());
    window.RemoveObservations(leaving);
  }

  WindowOptions options_;
  FeatureNoise noise_;
};

}  // namespace cvo
