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
  double box_shrink = 0.0;  // unary.box_shrink
};

// Returns for each detection the extent of the body in it, from those of its points that belong to
// no cluster (METHOD.md 6.2). The body is the first candidate that is spread over enough of the box
// (extent.mode_min_fill). If boxes share points, the box that they fill best gets them. Empty for
// detections that a cluster claims or that have no candidate. `nodes` has one entry per point.
std::vector<std::optional<CrfLabel::Extent>> FindNewBodies(const FrameView& view,
                                                           const NewBodyStep& step,
                                                           const std::vector<char>& is_claimed,
                                                           const std::vector<FramePoint>& points,
                                                           const std::vector<CrfNode>& nodes);

}  // namespace cvo
