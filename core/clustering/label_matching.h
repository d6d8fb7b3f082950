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

// The result of the CRF for landmarks that there were before. By node, all alike in length.
struct LabeledNodes {
  std::span<const int> label;
  std::span<const ClusterId> previous;  // invalid for a landmark without a cluster
};

// By label, the cluster it continues (section 3.2 of the paper, Kuhn-Munkres over intersection over
// union): all labels of clusters and new boxes compete for all clusters, and the label of a cluster
// that matches none keeps it if no other label took it. An invalid id for the outliers, and where a
// new cluster begins.
std::vector<ClusterId> MatchLabels(std::span<const LabelIdentity> labels, const LabeledNodes& nodes,
                                   const LabelMatchingOptions& options);

}  // namespace cvo
