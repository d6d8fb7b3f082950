// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "core/estimation/window_policies.h"
#include "core/solvers/measurement_noise.h"

namespace cvo {

// Marginalises the frame, together with the given landmarks (ascending) and all their observations,
// into the window's prior. Neither the frame nor the landmarks are removed from the window.
void MarginalizeFrame(FrameId frame, const std::vector<LandmarkId>& landmarks,
                      const FeatureNoise& noise, Window& window);

// Appends `frame` to T_t. If T_t is then too long, its oldest frame is promoted to T_s or
// discarded; if T_s is then too long, its oldest frame leaves the window as MarginalizationRule
// says (section 3.3 of the paper, "Double-Track Frame Management").
template <MarginalizationPolicy MarginalizationRule, PromotionPolicy SpatialTrack>
class DoubleTrack {
 public:
  DoubleTrack(const WindowOptions& options, const FeatureNoise& noise)
      : options_(options), noise_(noise) {}

  void Advance(const WindowFrame& frame, Window& window) const {
    window.temporal.push_back(frame);
    if (static_cast<int>(window.temporal.size()) <= options_.temporal) return;
    const WindowFrame tail = window.temporal.front();
    if (SpatialTrack::Promotes(window, tail, options_)) {
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
          MarginalizationRule::Marginalizes(landmark, newest, options_)) {
        marginalized.push_back(landmark.id);
      }
    }
    if constexpr (MarginalizationRule::kKeepsPrior) {
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
