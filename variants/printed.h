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

struct PrintedMotion : ClusterVo {
  static constexpr std::string_view kName = "printed_motion";
  static constexpr std::string_view kChanges =
      "clustervo with equation 8 as printed: a class without a pose fits perfectly";
  using MotionTerm = MotionTermLiteral;
};

struct PrintedKernel : ClusterVo {
  static constexpr std::string_view kName = "printed_kernel";
  static constexpr std::string_view kChanges =
      "clustervo with equation 9 as printed: the kernel is not normalised";
  using Pairwise = RawGaussianKernel;
};

struct PrintedSeconds : ClusterVo {
  static constexpr std::string_view kName = "printed_seconds";
  static constexpr std::string_view kChanges =
      "clustervo with Q = 0.01 in metres and seconds instead of metres and frames";
  using MotionPrior = WhiteNoiseOnTranslation;
  static void SetDefaults(Options& options) {
    ClusterVo::SetDefaults(options);
    options.motion_prior.q_m2_s3 = 0.01;
  }
};

}  // namespace cvo
