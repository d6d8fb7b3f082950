// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <span>
#include <vector>

#include "core/association/cluster_association_options.h"
#include "core/association/image_box.h"

namespace cvo {

// A landmark of a cluster where it is, or is expected, in the left image.
struct BoxMember {
  Eigen::Vector2d zeta_px = Eigen::Vector2d::Zero();
  // Of the measurement, of the landmark's predicted position (Gamma), and of both (S), px^6.
  double measurement_determinant = 1.0;
  double position_determinant = 1.0;
  double innovation_determinant = 1.0;
};

// p_q(m) of Eq. 3 of the paper for one cluster, and its entropy.
struct BoxProbabilities {
  std::vector<double> probability;  // by box
  std::vector<double> weight;       // by box: of the landmarks inside
  std::vector<int> members;         // by box: their number
  double entropy = 0.0;             // bits
};

// How much a landmark says, and over what the probabilities are normalised (METHOD.md 4.5).
template <typename Policy>
concept BoxWeightsPolicy = requires(std::span<const BoxMember> cluster,
                                    std::span<const ImageBox> boxes) {
  { Policy::Compute(cluster, boxes) } -> std::same_as<BoxProbabilities>;
};

// Policy: weights sqrt(|Sigma_z| / |S|) in (0, 1]; a null box takes landmarks that are in no box.
struct BoundedBoxWeights {
  static BoxProbabilities Compute(std::span<const BoxMember> cluster,
                                  std::span<const ImageBox> boxes);
};
// Policy: as printed, weights 1 / |Gamma|, no null box.
struct BoxWeightsLiteral {
  static BoxProbabilities Compute(std::span<const BoxMember> cluster,
                                  std::span<const ImageBox> boxes);
};

// What it costs to give a box to a cluster that has the probability p = p_q(m) of it and `share`
// of the weight that all clusters have in the box.
template <typename Policy>
concept BoxCostPolicy = requires(double p, double share) {
  { Policy::Cost(p, share) } -> std::same_as<double>;
};

// Policy: both count. p_q(m) alone does not say which of two clusters inside a box it shows.
struct SharedBoxCost {
  static double Cost(double p, double share);
};
// Policy: p_q(m) alone (the paper's argmax).
struct UnsharedBoxCost {
  static double Cost(double p, double share);
};

using BoxCostFunction = double (*)(double p, double share);

// The box of each cluster, or -1: one-to-one, as many pairs as can be, of least total cost.
std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options, BoxCostFunction cost);

}  // namespace cvo
