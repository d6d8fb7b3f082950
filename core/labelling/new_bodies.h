// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "core/clustering/crf_scene.h"
#include "core/clustering/depth_mode.h"
#include "core/clustering/point_extent.h"
#include "core/labelling/frame_points.h"

namespace cvo {

// What may be the body in a box that no cluster has: sets of its points, by their depths, the first
// choice first; and whether a point may be that of two boxes.
template <typename Policy>
concept NewBodyPolicy = requires(const std::vector<double>& depths_m, double angular_size,
                                 const ExtentOptions& options) {
  {
    Policy::Candidates(depths_m, angular_size, options)
    } -> std::same_as<std::vector<std::vector<int>>>;
  { Policy::kSharesPoints } -> std::convertible_to<bool>;
};

// Policy: dense ranges of depths, the nearest first.
struct NearestDepths {
  static constexpr bool kSharesPoints = false;
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m,
                                                  double angular_size,
                                                  const ExtentOptions& options) {
    return DepthModes(depths_m, angular_size, options);
  }
};
// Policy: all of them, if there are extent.mode_min_points.
struct AllDepths {
  static constexpr bool kSharesPoints = true;
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m, double,
                                                  const ExtentOptions& options);
};

// A policy as FindNewBodies takes it.
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
  double box_shrink = 0.0;  // unary.box_shrink
};

// By detection: where the body in it is, as far as its points tell, those of no cluster
// (METHOD.md 6.2). Of its candidates the first one that is spread over enough of the box
// (extent.mode_min_fill); of boxes with the same points the one that they fill best has them. Empty
// for detections that a cluster claims. `nodes` by point.
std::vector<std::optional<CrfLabel::Extent>> FindNewBodies(const FrameView& view,
                                                           const NewBodyStep& step,
                                                           const std::vector<char>& is_claimed,
                                                           const std::vector<FramePoint>& points,
                                                           const std::vector<CrfNode>& nodes);

}  // namespace cvo
