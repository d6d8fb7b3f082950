// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "variants/clustervo.h"

namespace cvo {

// Each variant reverts one correction of METHOD.md 9 in ClusterVo, to show what the equation does
// as printed.
struct PrintedGate : ClusterVo {
  static constexpr std::string_view kName = "printed_gate";
  static constexpr std::string_view kChanges =
      "clustervo with equation 2 as printed: the gate uses only the covariance of the position";
  using LandmarkAssociation = ProbabilisticAssociationLiteral;
};

struct PrintedBoxes : ClusterVo {
  static constexpr std::string_view kName = "printed_boxes";
  static constexpr std::string_view kChanges =
      "clustervo with equation 6 as printed: outside boxes, all classes are equally likely";
  using BoxTerm = Box2dTermLiteral;
};

struct PrintedAffinity : ClusterVo {
  static constexpr std::string_view kName = "printed_affinity";
  static constexpr std::string_view kChanges =
      "clustervo with equation 7 as printed: the Mahalanobis distance over a squared length";
  using AffinityTerm = AffinityTermLiteral;
};

struct PrintedKernel : ClusterVo {
  static constexpr std::string_view kName = "printed_kernel";
  static constexpr std::string_view kChanges =
      "clustervo with equation 9 as printed: the kernel is not normalised";
  using Pairwise = RawGaussianKernel;
};

}  // namespace cvo
