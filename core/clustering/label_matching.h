// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/options.h"
#include "core/clustering/dense_crf.h"

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
  ClusterId cluster;  // for kStatic and kCluster
};

// Result of the CRF for landmarks that existed before this frame. Both spans have one entry per
// node.
struct LabeledNodes {
  std::span<const int> label;
  std::span<const ClusterId> previous;  // invalid for a landmark without a cluster
};

// Returns for each label the cluster that it continues (section 3.2 of the paper, Kuhn-Munkres over
// intersection over union). All labels of clusters and new boxes compete for all clusters; the
// label of a cluster that matches none keeps its cluster if no other label took it. The id is
// invalid for the outlier class and for labels that start a new cluster. Throws Error on a label
// out of range.
std::vector<ClusterId> MatchLabels(std::span<const LabelIdentity> labels, const LabeledNodes& nodes,
                                   const LabelMatchingOptions& options);

}  // namespace cvo
