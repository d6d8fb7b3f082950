// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/estimation/marginalization.h"
#include "core/estimation/window.h"

namespace cvo {

struct WindowOptions {
  int spatial = 5;
  int temporal = 15;
  double promote_translation = 0.12;
  double promote_rotation_rad = 0.1745;
  double promote_common = 0.6;
  int lost_frames = 3;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("spatial", self.spatial,
                {"frames", 1, 100, "frames in the spatial track, |T_s|", "paper, section 4.1"});
    visit.Field("temporal", self.temporal,
                {"frames", 2, 200, "frames in the temporal track, |T_t|", "paper, section 4.1"});
    visit.Field("promote_translation", self.promote_translation,
                {"median depths", 0, 100,
                 "a frame this far from the newest one in T_s is promoted; larger spans more time "
                 "with less overlap",
                 "estimator.md 4.1"});
    visit.Field("promote_rotation_rad", self.promote_rotation_rad,
                {"rad", 0, 3.15, "a frame turned this far from the newest one in T_s is promoted",
                 "estimator.md 4.1"});
    visit.Field(
        "promote_common", self.promote_common,
        {"1", 0, 1,
         "a frame sharing less than this fraction of landmarks with the newest one in T_s is "
         "promoted",
         "estimator.md 4.1"});
    visit.Field("lost_frames", self.lost_frames,
                {"frames", 1, 100,
                 "a landmark unseen in this many latest frames is lost: its observations are "
                 "marginalised with the frame they leave with",
                 "estimator.md 4.3"});
  }
};

// What becomes of a landmark seen by the frame that leaves T_s: marginalised with all its
// observations, or only that observation deleted (estimator.md 4.3).
// Policy: unseen in the last lost_frames frames -> marginalised.
struct MarginalizeLost {
  static bool KeepsPrior() { return true; }
  static bool Marginalizes(const Landmark& landmark, FrameId newest, const WindowOptions& options) {
    return landmark.last_seen.value <= newest.value - options.lost_frames;
  }
};
// Policy: unseen by the newest frame -> marginalised, the paper's rule.
struct MarginalizeUnseenByNewest {
  static bool KeepsPrior() { return true; }
  static bool Marginalizes(const Landmark& landmark, FrameId newest, const WindowOptions&) {
    return landmark.last_seen < newest;
  }
};
// Policy: nothing is marginalised, there is no prior.
struct MarginalizeNothing {
  static bool KeepsPrior() { return false; }
  static bool Marginalizes(const Landmark&, FrameId, const WindowOptions&) { return false; }
};

// What holds the window in the world. Policy: its oldest frame is held constant.
struct FixOldestFrame {
  static bool Fixes(int index, const PosePrior&) { return index == 0; }
};
// Policy: the prior alone, once there is one (the paper's).
struct PriorHoldsGauge {
  static bool Fixes(int index, const PosePrior& prior) { return index == 0 && prior.empty(); }
};

// Whether a frame leaving T_t joins T_s. Policy: far from the newest frame in T_s.
struct PromoteDistant {
  static bool Promotes(const Window& window, const WindowFrame& frame,
                       const WindowOptions& options);
};
// Policy: never; T_s stays empty.
struct PromoteNever {
  static bool Promotes(const Window&, const WindowFrame&, const WindowOptions&) { return false; }
};

// The part of the window's energy that marginalising `leaving` touches: the landmarks it sees for
// which `marginalizes` holds, with all their observations, and the prior.
WindowProblem CollectMarginalized(const Window& window, const PosePrior& prior,
                                  const std::vector<LandmarkId>& landmarks,
                                  const NoiseOptions& noise, double scale_factor);

// Appends `frame` to T_t and makes room: the oldest frame of T_t is promoted or discarded, the
// oldest of T_s is marginalised (section 3.3 of the paper, "Double-Track Frame Management").
template <typename MarginalizationRule, typename SpatialTrack>
class DoubleTrack {
 public:
  DoubleTrack(const StereoCamera& camera, const WindowOptions& options, const NoiseOptions& noise,
              double scale_factor)
      : camera_(camera), options_(options), noise_(noise), scale_factor_(scale_factor) {}

  void Advance(const WindowFrame& frame, Window& window, PosePrior& prior) const {
    window.temporal.push_back(frame);
    if (static_cast<int>(window.temporal.size()) <= options_.temporal) return;
    const WindowFrame tail = window.temporal.front();
    const bool promoted = SpatialTrack::Promotes(window, tail, options_);
    if (promoted) {
      window.temporal.erase(window.temporal.begin());
      window.spatial.push_back(tail);
      if (static_cast<int>(window.spatial.size()) > options_.spatial) {
        RemoveSpatial(frame.id, window, prior);
      }
    } else {
      Discard(tail.id, window, prior);
      window.temporal.erase(window.temporal.begin());
    }
    window.RemoveUnobserved();
  }

 private:
  // A discarded frame's observations are lost; what the prior says of it is summed out.
  void Discard(FrameId id, Window& window, PosePrior& prior) const {
    if (std::find(prior.frames.begin(), prior.frames.end(), id) != prior.frames.end()) {
      Eliminate(id, {}, window, prior);
    }
    window.RemoveObservations(id);
  }

  void RemoveSpatial(FrameId newest, Window& window, PosePrior& prior) const {
    const FrameId leaving = window.spatial.front().id;
    std::vector<LandmarkId> marginalized;
    for (const Landmark& landmark : window.landmarks) {
      if (FindObservation(landmark, leaving) && landmark.observations.size() >= 2 &&
          MarginalizationRule::Marginalizes(landmark, newest, options_)) {
        marginalized.push_back(landmark.id);
      }
    }
    if (MarginalizationRule::KeepsPrior()) Eliminate(leaving, marginalized, window, prior);
    std::erase_if(window.landmarks, [&](const Landmark& landmark) {
      return std::binary_search(marginalized.begin(), marginalized.end(), landmark.id);
    });
    window.spatial.erase(window.spatial.begin());
    window.RemoveObservations(leaving);
  }

  void Eliminate(FrameId leaving, const std::vector<LandmarkId>& landmarks, const Window& window,
                 PosePrior& prior) const {
    const WindowProblem problem =
        CollectMarginalized(window, prior, landmarks, noise_, scale_factor_);
    prior = Marginalize(camera_, noise_, problem, leaving);
  }

  StereoCamera camera_;
  WindowOptions options_;
  NoiseOptions noise_;
  double scale_factor_;
};

}  // namespace cvo
