// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/association/box_association.h"
#include "core/clustering/dense_crf.h"

namespace cvo {
namespace {

// Minimum intersection over union of a label and the cluster that it continues (METHOD.md 5.7).
constexpr double kMinIou = 0.3;

std::vector<int> LabelsOfBodies(std::span<const CrfLabel> labels) {
  std::vector<int> chosen;
  for (int label = 0; label < static_cast<int>(labels.size()); ++label) {
    const LabelKind kind = labels[label].kind;
    if (kind == LabelKind::kCluster || kind == LabelKind::kNewBox) chosen.push_back(label);
  }
  return chosen;
}

// Clusters other than the static scene that nodes belonged to, sorted by id.
std::vector<ClusterId> PreviousClusters(std::span<const ClusterId> previous_of_node) {
  std::vector<ClusterId> clusters(previous_of_node.begin(), previous_of_node.end());
  std::erase_if(clusters, [](ClusterId id) { return !id.valid() || id == kStaticScene; });
  std::sort(clusters.begin(), clusters.end());
  clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
  return clusters;
}

// Intersection over union of the nodes of each chosen label (row) and each cluster (column).
Eigen::MatrixXd Overlaps(std::span<const int> chosen, std::span<const ClusterId> clusters,
                         const LabeledNodes& nodes) {
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(chosen.size(), clusters.size());
  Eigen::VectorXd of_label = Eigen::VectorXd::Zero(chosen.size());
  Eigen::RowVectorXd of_cluster = Eigen::RowVectorXd::Zero(clusters.size());
  for (std::size_t i = 0; i < nodes.label.size(); ++i) {
    const auto label = std::lower_bound(chosen.begin(), chosen.end(), nodes.label[i]);
    const auto cluster = std::lower_bound(clusters.begin(), clusters.end(), nodes.previous[i]);
    const bool is_in_label = label != chosen.end() && *label == nodes.label[i];
    const bool is_in_cluster = cluster != clusters.end() && *cluster == nodes.previous[i];
    if (is_in_label) of_label[label - chosen.begin()] += 1.0;
    if (is_in_cluster) of_cluster[cluster - clusters.begin()] += 1.0;
    if (is_in_label && is_in_cluster) {
      shared(label - chosen.begin(), cluster - clusters.begin()) += 1.0;
    }
  }
  const Eigen::MatrixXd either =
      of_label.replicate(1, of_cluster.size()) + of_cluster.replicate(of_label.size(), 1) - shared;
  return shared.cwiseQuotient(either.cwiseMax(1.0));
}

// Assigns clusters to the chosen labels such that the total overlap is largest.
void MatchByOverlap(std::span<const int> chosen, std::span<const ClusterId> clusters,
                    const LabeledNodes& nodes, std::vector<ClusterId>& matched) {
  const Eigen::MatrixXd overlaps = Overlaps(chosen, clusters, nodes);
  const std::vector<int> assigned = Assign(-overlaps);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (assigned[k] < 0 || overlaps(k, assigned[k]) < kMinIou) continue;
    matched[chosen[k]] = clusters[assigned[k]];
  }
}

}  // namespace

std::vector<ClusterId> MatchLabels(std::span<const CrfLabel> labels, const LabeledNodes& nodes) {
  std::vector<ClusterId> matched(labels.size());
  MatchByOverlap(LabelsOfBodies(labels), PreviousClusters(nodes.previous), nodes, matched);
  const std::vector<ClusterId> taken = matched;
  for (std::size_t label = 0; label < labels.size(); ++label) {
    if (!matched[label].valid() && std::ranges::count(taken, labels[label].cluster) == 0) {
      matched[label] = labels[label].cluster;
    }
  }
  return matched;
}

}  // namespace cvo
