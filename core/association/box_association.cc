// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/box_association.h"

#include <cmath>
#include <limits>

#include "core/association/assignment.h"

namespace cvo {
namespace {

// Weights and numbers of members in each box, and the weight of the members in no box.
struct BoxSums {
  std::vector<double> by_box;
  std::vector<int> members;
  double in_none = 0.0;
};

template <typename Weight>
BoxSums SumWeights(std::span<const BoxMember> cluster, std::span<const ImageBox> boxes,
                   Weight weight) {
  BoxSums sums{std::vector<double>(boxes.size(), 0.0), std::vector<int>(boxes.size(), 0)};
  for (const BoxMember& member : cluster) {
    const double w = weight(member);
    bool in_any = false;
    for (std::size_t m = 0; m < boxes.size(); ++m) {
      if (!boxes[m].Contains(member.zeta_px[0], member.zeta_px[1])) continue;
      sums.by_box[m] += w;
      ++sums.members[m];
      in_any = true;
    }
    if (!in_any) sums.in_none += w;
  }
  return sums;
}

double Information(double p) { return p > 0.0 ? -p * std::log(p) : 0.0; }

// Computes the probabilities and their entropy. `in_none` is the weight of the null box.
BoxProbabilities Normalize(const BoxSums& sums, double in_none) {
  BoxProbabilities result{sums.by_box, sums.by_box, sums.members, 0.0};
  double total = in_none;
  for (const double weight : sums.by_box) total += weight;
  if (!(total > 0.0)) return result;
  for (double& p : result.probability) {
    p /= total;
    result.entropy += Information(p);
  }
  result.entropy += Information(in_none / total);
  result.entropy /= std::log(2.0);
  return result;
}

}  // namespace

BoxProbabilities BoundedBoxWeights::Compute(std::span<const BoxMember> cluster,
                                            std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(cluster, boxes, [](const BoxMember& member) {
    return std::sqrt(member.measurement_determinant / member.innovation_determinant);
  });
  return Normalize(sums, sums.in_none);
}

BoxProbabilities BoxWeightsLiteral::Compute(std::span<const BoxMember> cluster,
                                            std::span<const ImageBox> boxes) {
  const BoxSums sums = SumWeights(
      cluster, boxes, [](const BoxMember& member) { return 1.0 / member.position_determinant; });
  return Normalize(sums, 0.0);
}

double SharedBoxCost::Cost(double p, double share) { return -std::log(p) - std::log(share); }

double UnsharedBoxCost::Cost(double p, double) { return -std::log(p); }

std::vector<int> AssociateBoxes(std::span<const BoxProbabilities> clusters, int boxes,
                                const ClusterAssociationOptions& options, BoxCostFunction cost) {
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(clusters.size()),
                                                    boxes, std::numeric_limits<double>::infinity());
  std::vector<double> total(static_cast<std::size_t>(boxes), 0.0);
  for (const BoxProbabilities& cluster : clusters) {
    for (int m = 0; m < boxes; ++m) total[m] += cluster.weight[m];
  }
  for (std::size_t q = 0; q < clusters.size(); ++q) {
    if (!(clusters[q].entropy < options.max_entropy)) continue;
    for (int m = 0; m < boxes; ++m) {
      const double p = clusters[q].probability[m];
      if (p < options.min_box_probability || !(p > 0.0)) continue;
      if (clusters[q].members[m] < options.min_box_members) continue;
      costs(static_cast<Eigen::Index>(q), m) = cost(p, clusters[q].weight[m] / total[m]);
    }
  }
  return Assign(costs);
}

}  // namespace cvo
