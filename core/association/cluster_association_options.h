// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Maximum descriptor distance without a prediction (METHOD.md 4.6).
inline constexpr int kRematchHamming = 60;
// Maximum ratio of the best to the second best distance without a prediction (METHOD.md 4.6).
inline constexpr double kRematchRatio = 0.85;
// RANSAC hypotheses per cluster: with 35 % inliers, 100 succeed with probability 99 % (1 - (1 -
// 0.35^3)^100).
inline constexpr int kRansacIterations = 100;

// Options for the association of features and boxes with clusters (section 3.1 of the paper).
struct ClusterAssociationOptions {
  double gamma = 4.0;
  double max_radius_px = 60.0;
  int max_hamming = 75;
  double ratio = 0.9;
  double max_entropy = 20.0;
  int min_rematch = 7;
  bool left_only = true;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("gamma", self.gamma,
                {"1", 0.1, 1000,
                 "gate on the squared Mahalanobis distance of a feature from its prediction; "
                 "larger gives fewer missed and more false matches",
                 "paper, section 3.1; 74 % of chi^2 with 3 degrees of freedom"});
    visit.Field("max_radius_px", self.max_radius_px,
                {"px", 1, 500, "maximum search radius", "METHOD.md 4.2"});
    visit.Field("max_hamming", self.max_hamming,
                {"bits", 1, 256, "maximum descriptor distance within the gate", "METHOD.md 4.3"});
    visit.Field("ratio", self.ratio,
                {"1", 0.1, 1.0, "maximum ratio of the best to the second best distance",
                 "as for static landmarks"});
    visit.Field(
        "max_entropy", self.max_entropy,
        {"bit", 0, 20,
         "maximum entropy of a cluster's distribution over boxes for the cluster to be assigned to "
         "one; 20: no limit",
         "METHOD.md 4.5; 1 in the paper"});
    visit.Field(
        "min_rematch", self.min_rematch,
        {"landmarks", 3, 1000,
         "minimum consistent landmarks to accept a pose that was not predicted",
         "three fix the pose; four more agree by chance in less than one box in a thousand"});
    visit.Field("left_only", self.left_only,
                {"1", 0, 1,
                 "whether landmarks of clusters are also searched for in the left image only, if "
                 "the right image does not show them",
                 "METHOD.md 4.7"});
  }
};

}  // namespace cvo
