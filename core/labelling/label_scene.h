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

// The classes of the CRF in one frame, M = N1 + N2 + 1: the static scene and the live clusters,
// detections that belong to none of them, and the outlier class last.
struct LabelScene {
  CrfScene crf;                    // nodes by point
  std::vector<int> detection;      // by label: a cluster's or new box's detection; -1: none
  std::vector<BodyId> given_body;  // by label, as GivenKnowledge says; invalid: unknown
  int clusters = 0;                // labels 1 ... clusters are map.live[0], ...

  int Outlier() const { return static_cast<int>(crf.labels.size()) - 1; }
  bool IsNewBox(int label) const { return label > clusters && label < Outlier(); }
};

// Where the motion and the pairwise term take a landmark to be now; empty: Z_t^i.
template <typename Policy>
concept PointPlacePolicy = requires(const RigidTransform& camera_from_object,
                                    const Landmark& landmark) {
  { Policy::Place(camera_from_object, landmark) } -> std::same_as<std::optional<CrfNode::Place>>;
};

// Policy: Z_t^i, where the current frame alone sees it, with the noise of that.
struct TriangulatedPlace {
  static std::optional<CrfNode::Place> Place(const RigidTransform&, const Landmark&) { return {}; }
};
// Policy: p_t^i, where the body's pose puts it, taken as exact: the paper's. New points have none.
struct EstimatedPlace {
  static std::optional<CrfNode::Place> Place(const RigidTransform& camera_from_object,
                                             const Landmark& landmark) {
    return CrfNode::Place{camera_from_object * landmark.p_in_object};
  }
};

// Which earlier observation of a landmark the motion term takes, of those within
// unary.past_frames frames: the oldest one `Takes` accepts, by the number of frames after the
// first of these.
template <typename Policy>
concept PastFramePolicy = requires(int later) {
  { Policy::Takes(later) } -> std::same_as<bool>;
};

// Policy: the oldest one there is.
struct OldestPastFrame {
  static bool Takes(int) { return true; }
};
// Policy: that of exactly unary.past_frames frames ago, the paper's t - 5.
struct ExactPastFrame {
  static bool Takes(int later) { return later == 0; }
};

// What BuildLabelScene reads.
struct LabelSceneOptions {
  FeatureNoise noise;
  UnaryOptions unary;
  ExtentOptions extent;
  ClusterOptions clusters;
  int past_frames = 0;  // that the motion term looks back
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

// What is known of every point and every class (section 3.2 of the paper). The current frame is
// the one after the window's newest.
LabelScene BuildLabelScene(const FrameView& view, const LabelSceneOptions& options,
                           const Window& window, const ClusterMap& map,
                           const std::vector<ClusterTrack>& tracks,
                           const std::vector<FramePoint>& points, const LabelSceneSteps& steps);

}  // namespace cvo
