// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "core/clustering/crf_scene.h"
#include "core/clustering/unary_options.h"
#include "core/labelling/frame_points.h"
#include "core/labelling/new_bodies.h"

namespace cvo {

// The nodes and classes of the CRF in one frame. The M = N1 + N2 + 1 classes are, in this order,
// the static scene and the live clusters, the detections that belong to none of them, and the
// outlier class.
struct LabelScene {
  CrfScene crf;                    // one node per point
  std::vector<int> detection;      // per label: that of the cluster or new box; -1: none
  std::vector<BodyId> given_body;  // per label, see GivenKnowledge; invalid: unknown
  int clusters = 0;                // labels 1 ... clusters are map.live[0], ...

  int Outlier() const { return static_cast<int>(crf.labels.size()) - 1; }
  bool IsNewBox(int label) const { return label > clusters && label < Outlier(); }
};

// Where the motion and pairwise terms assume a landmark to be in the current camera frame; empty:
// Z_t^i.
template <typename Policy>
concept PointPlacePolicy = requires(const RigidTransform& camera_from_object,
                                    const Landmark& landmark) {
  { Policy::Place(camera_from_object, landmark) } -> std::same_as<std::optional<CrfNode::Place>>;
};

// Policy: Z_t^i, triangulated from the current frame alone, with the noise of that triangulation.
struct TriangulatedPlace {
  static std::optional<CrfNode::Place> Place(const RigidTransform&, const Landmark&) { return {}; }
};
// Policy: p_t^i, where the pose of the body places the landmark, taken as exact, as in the paper.
// New points have no p_t^i.
struct EstimatedPlace {
  static std::optional<CrfNode::Place> Place(const RigidTransform& camera_from_object,
                                             const Landmark& landmark) {
    return CrfNode::Place{camera_from_object * landmark.p_in_object};
  }
};

// Which earlier observation of a landmark the motion term uses: within the last unary.past_frames
// frames, the oldest one that `Takes` accepts. `later` is the number of frames by which it comes
// after the first of these frames.
template <typename Policy>
concept PastFramePolicy = requires(int later) {
  { Policy::Takes(later) } -> std::same_as<bool>;
};

// Policy: the oldest observation.
struct OldestPastFrame {
  static bool Takes(int) { return true; }
};
// Policy: the observation exactly unary.past_frames frames ago, the paper's t - 5.
struct ExactPastFrame {
  static bool Takes(int later) { return later == 0; }
};

// Options of BuildLabelScene.
struct LabelSceneOptions {
  FeatureNoise noise;
  UnaryOptions unary;
  ExtentOptions extent;
  ClusterOptions clusters;
  int past_frames = 0;  // how far the motion term looks back
};

// The policies of BuildLabelScene.
struct LabelSceneSteps {
  std::optional<CrfNode::Place> (*place)(const RigidTransform&, const Landmark&);
  bool (*takes_past)(int later);
  NewBodyRule new_body;
};

template <PointPlacePolicy PointPlace, PastFramePolicy PastFrame, NewBodyPolicy NewBody>
constexpr LabelSceneSteps StepsOf() {
  return {&PointPlace::Place, &PastFrame::Takes, RuleOf<NewBody>()};
}

// Collects what is known of every point and every class (section 3.2 of the paper). The current
// frame is the one after the newest frame of the window.
LabelScene BuildLabelScene(const FrameView& view, const LabelSceneOptions& options,
                           const Window& window, const ClusterMap& map,
                           const std::vector<ClusterTrack>& tracks,
                           const std::vector<FramePoint>& points, const LabelSceneSteps& steps);

}  // namespace cvo
