// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Solves the assignment problem (Kuhn-Munkres). Returns the column of each row, or -1. A cost of
// infinity forbids a pair. The assignment has as many pairs as possible and, among those
// assignments, the least total cost. Of equal totals, it is the one in which row 0 has the lowest
// column, then row 1, and so on; no column at all ranks behind every column. Costs that differ by
// less than 1e-12 of the largest are equal. O(rows * (rows + columns)^2). Throws Error on
// NaN or minus infinity.
std::vector<int> Assign(const Eigen::MatrixXd& cost);

// Enlarges the box such that it contains the pixel.
inline void Include(double u_px, double v_px, ImageBox& box) {
  box = {std::min(box.left_px, u_px), std::min(box.top_px, v_px), std::max(box.right_px, u_px),
         std::max(box.bottom_px, v_px)};
}

// p_q(m) of Eq. 3 of the paper for one cluster, and the entropy of this distribution.
struct BoxProbabilities {
  std::vector<double> probability;  // by box
  std::vector<double> weight;       // by box: sum over the landmarks inside
  double entropy = 0.0;             // bits
};

// Policies for the boxes of clusters (METHOD.md 4.5): the probabilities of Eq. 3 from the landmarks
// of a cluster at their observed or predicted positions; the cost of a box with probability
// p = p_q(m) for a cluster that has `share` of the weight of all clusters in it; and whether a
// cluster refuses boxes of other classes, which the paper does not compare.

// Policy: ours, with weights sqrt(|Sigma_z| / |S|) in (0, 1]; landmarks that are in no box count
// for a null box. p alone does not tell which of two clusters inside a box the box shows.
struct BoundedBoxes {
  static constexpr bool kComparesClasses = true;
  static BoxProbabilities Compute(std::span<const PredictedLandmark> cluster,
                                  std::span<const ImageBox> boxes);
  static double Cost(double p, double share);
};
// Policy: the paper's, with weights 1 / |Gamma|, no null box, and the argmax of p alone.
struct PrintedBoxWeights {
  static constexpr bool kComparesClasses = false;
  static BoxProbabilities Compute(std::span<const PredictedLandmark> cluster,
                                  std::span<const ImageBox> boxes);
  static double Cost(double p, double share);
};

// Returns the box of each cluster, or -1. The assignment is one-to-one, with as many of the pairs
// that `options` allow as possible and, among those assignments, the least total cost.
std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options,
                                double (*cost)(double p, double share));

}  // namespace cvo
