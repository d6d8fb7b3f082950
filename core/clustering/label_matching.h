// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/options.h"
#include "core/clustering/crf_scene.h"

namespace cvo {

struct LabelMatchingOptions {
  double min_iou = 0.3;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_iou", self.min_iou,
                {"1", 0.01, 1.0,
                 "minimum intersection over union of the landmarks of a new box and an existing "
                 "cluster to match them; below it a new cluster is created",
                 "METHOD.md 5.7"});
  }
};

// What a label of the CRF represents.
struct LabelIdentity {
  LabelKind kind = LabelKind::kStatic;
  ClusterId cluster;  // of kStatic and kCluster
};

// By label, the cluster it continues (section 3.2 of the paper, Kuhn-Munkres): its own; for a new
// box the cluster, among those without a label and not the static scene, that its nodes were in
// before, or an invalid id; for the outliers an invalid id.
// label_of_node: result of the CRF. previous_of_node: invalid for a landmark without a cluster.
std::vector<ClusterId> MatchLabels(std::span<const LabelIdentity> labels,
                                   std::span<const int> label_of_node,
                                   std::span<const ClusterId> previous_of_node,
                                   const LabelMatchingOptions& options);

}  // namespace cvo
