// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/point_extent.h"
#include "core/clusters/cluster_prediction.h"
#include "core/estimation/window.h"

namespace cvo {

// Owner of a point's landmark: none yet, the static scene (window.landmarks) or a live cluster
// (map.live[cluster].landmarks).
struct PointOwner {
  enum class Kind { kUnassigned, kScene, kCluster };
  Kind kind = Kind::kUnassigned;
  int cluster = -1;

  friend constexpr bool operator==(const PointOwner&, const PointOwner&) = default;
};
inline constexpr PointOwner kNoOwner{};
inline constexpr PointOwner kSceneOwner{PointOwner::Kind::kScene, -1};
constexpr PointOwner ClusterOwner(int cluster) { return {PointOwner::Kind::kCluster, cluster}; }

// A feature of the current frame and the landmark that it observes.
struct FramePoint {
  int feature = 0;
  PointOwner owner;
  int landmark = -1;  // index into the owner's landmarks
};

// Returns the indices of features that may show the static scene: all except those found in the
// left image only and reserve features outside all detections, which would cost time without
// improving a scene that has enough features.
std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections);

// Returns, in the order of the features, all that are matched with the static scene or with
// clusters, and all new ones that may become landmarks: those found in the right image with a
// disparity of at least min_disparity_px; of the reserve, only those inside a detection or the
// expected box of a cluster.
std::vector<FramePoint> CollectPoints(const FrameView& view, double min_disparity_px,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks);

// Returns the landmark of a point; null if it has none.
const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map);

// Returns world_from_object of the owner in a frame of the window: the identity for the static
// scene, empty for a cluster without a state in that frame.
std::optional<RigidTransform> OwnerPose(PointOwner owner, FrameId frame, const ClusterMap& map);

// Which of the points in a box that no cluster claims may be the body: candidate sets of points by
// depth, in order of preference. kSharesPoints: whether the bodies of two boxes may share points.
template <typename Policy>
concept NewBodyPolicy = requires(const std::vector<double>& depths_m, double angular_size,
                                 const ExtentOptions& options) {
  {
    Policy::Candidates(depths_m, angular_size, options)
    } -> std::same_as<std::vector<std::vector<int>>>;
  { Policy::kSharesPoints } -> std::convertible_to<bool>;
};

// Policy: the dense ranges of depths, nearest first.
struct NearestDepths {
  static constexpr bool kSharesPoints = false;
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m,
                                                  double angular_size,
                                                  const ExtentOptions& options) {
    return DepthModes(depths_m, angular_size, options);
  }
};
// Policy: all points, if there are at least extent.mode_min_points.
struct AllDepths {
  static constexpr bool kSharesPoints = true;
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m, double,
                                                  const ExtentOptions& options);
};

// A NewBodyPolicy as an argument of FindNewBodies.
struct NewBodyRule {
  std::vector<std::vector<int>> (*candidates)(const std::vector<double>&, double,
                                              const ExtentOptions&);
  bool shares_points;
};
template <NewBodyPolicy Policy>
constexpr NewBodyRule RuleOf() {
  return {&Policy::Candidates, Policy::kSharesPoints};
}

struct NewBodyStep {
  NewBodyRule rule;
  ExtentOptions extent;
};

// Returns for each detection the extent of the body in it, from those of its points that belong to
// no cluster (METHOD.md 6.2). The body is the first candidate that is spread over enough of the box
// (ExtentOptions::kModeMinFill). If boxes share points, the box that they fill best gets them.
// Empty for detections that a cluster claims or that have no candidate. `nodes` has one entry per
// point.
std::vector<std::optional<CrfLabel::Extent>> FindNewBodies(const FrameView& view,
                                                           const NewBodyStep& step,
                                                           const std::vector<char>& is_claimed,
                                                           const std::vector<FramePoint>& points,
                                                           const std::vector<CrfNode>& nodes);

}  // namespace cvo
