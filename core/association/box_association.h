// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include "core/association/cluster_association_options.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Solves the assignment problem (Kuhn-Munkres). Returns the column of each row, or -1. A cost of
// infinity forbids a pair. The assignment has as many pairs as possible and, among those
// assignments, the least total cost. Of equal totals, it is the one in which row 0 has the lowest
// column, then row 1, and so on; no column at all ranks behind every column. Costs that differ by
// less than 1e-12 of the largest are equal. O(rows * columns * min(rows, columns)). Throws Error on
// NaN or minus infinity.
std::vector<int> Assign(const Eigen::MatrixXd& cost);

// A landmark of a cluster at its observed or predicted position in the left image.
struct BoxMember {
  Eigen::Vector2d zeta_px = Eigen::Vector2d::Zero();
  // Determinants of the covariances of the measurement (Sigma_z), of the predicted position of the
  // landmark (Gamma), and of the innovation (S), px^6.
  double measurement_determinant = 1.0;
  double position_determinant = 1.0;
  double innovation_determinant = 1.0;
};

// p_q(m) of Eq. 3 of the paper for one cluster, and the entropy of this distribution.
struct BoxProbabilities {
  std::vector<double> probability;  // by box
  std::vector<double> weight;       // by box: sum over the landmarks inside
  double entropy = 0.0;             // bits
};

// Defines the weight of a landmark and the normalisation of the probabilities (METHOD.md 4.5).
template <typename Policy>
concept BoxWeightsPolicy = requires(std::span<const BoxMember> cluster,
                                    std::span<const ImageBox> boxes) {
  { Policy::Compute(cluster, boxes) } -> std::same_as<BoxProbabilities>;
};

// Policy: weights sqrt(|Sigma_z| / |S|) in (0, 1]; landmarks that are in no box count for a null
// box.
struct BoundedBoxWeights {
  static BoxProbabilities Compute(std::span<const BoxMember> cluster,
                                  std::span<const ImageBox> boxes);
};
// Policy: as printed in the paper, with weights 1 / |Gamma| and no null box.
struct BoxWeightsLiteral {
  static BoxProbabilities Compute(std::span<const BoxMember> cluster,
                                  std::span<const ImageBox> boxes);
};

// Cost of assigning a box to a cluster with probability p = p_q(m) for it and with `share` of the
// weight that all clusters have in the box.
template <typename Policy>
concept BoxCostPolicy = requires(double p, double share) {
  { Policy::Cost(p, share) } -> std::same_as<double>;
};

// Policy: uses both. p_q(m) alone does not tell which of two clusters inside a box the box shows.
struct SharedBoxCost {
  static double Cost(double p, double share);
};
// Policy: uses p_q(m) alone (the argmax of the paper).
struct UnsharedBoxCost {
  static double Cost(double p, double share);
};

using BoxCostFunction = double (*)(double p, double share);

// Returns the box of each cluster, or -1. The assignment is one-to-one, with as many of the pairs
// that `options` allow as possible and, among those assignments, the least total cost.
std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options, BoxCostFunction cost);

}  // namespace cvo
