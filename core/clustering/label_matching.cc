// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/label_matching.h"

#include <algorithm>

#include "core/association/assignment.h"

namespace cvo {
namespace {

void CheckInput(std::span<const LabelIdentity> labels, std::span<const int> label_of_node,
                std::span<const ClusterId> previous_of_node) {
  Require(label_of_node.size() == previous_of_node.size(),
          "MatchLabels: needs a label and a previous cluster for each node");
  for (const int label : label_of_node) {
    if (label < 0 || label >= static_cast<int>(labels.size())) {
      ThrowError("MatchLabels", StrCat("label ", label), StrCat("one of ", labels.size()));
    }
  }
}

std::vector<int> NewBoxes(std::span<const LabelIdentity> labels) {
  std::vector<int> boxes;
  for (int label = 0; label < static_cast<int>(labels.size()); ++label) {
    if (labels[label].kind == LabelKind::kNewBox) boxes.push_back(label);
  }
  return boxes;
}

// Moving clusters that nodes were in and that have no label, by id.
std::vector<ClusterId> CandidateClusters(std::span<const LabelIdentity> labels,
                                         std::span<const ClusterId> previous_of_node) {
  std::vector<ClusterId> candidates;
  for (const ClusterId cluster : previous_of_node) {
    const bool has_label =
        std::any_of(labels.begin(), labels.end(), [&](const LabelIdentity& label) {
          return label.kind == LabelKind::kCluster && label.cluster == cluster;
        });
    if (cluster.valid() && cluster != kStaticScene && !has_label) candidates.push_back(cluster);
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

// Nodes in both over nodes in either.
Eigen::MatrixXd Overlaps(std::span<const int> boxes, std::span<const ClusterId> clusters,
                         std::span<const int> label_of_node,
                         std::span<const ClusterId> previous_of_node) {
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(boxes.size(), clusters.size());
  Eigen::VectorXd of_box = Eigen::VectorXd::Zero(boxes.size());
  Eigen::RowVectorXd of_cluster = Eigen::RowVectorXd::Zero(clusters.size());
  for (std::size_t i = 0; i < label_of_node.size(); ++i) {
    const auto box = std::lower_bound(boxes.begin(), boxes.end(), label_of_node[i]);
    const auto cluster = std::lower_bound(clusters.begin(), clusters.end(), previous_of_node[i]);
    const bool is_in_box = box != boxes.end() && *box == label_of_node[i];
    const bool is_in_cluster = cluster != clusters.end() && *cluster == previous_of_node[i];
    if (is_in_box) of_box[box - boxes.begin()] += 1.0;
    if (is_in_cluster) of_cluster[cluster - clusters.begin()] += 1.0;
    if (is_in_box && is_in_cluster) {
      shared(box - boxes.begin(), cluster - clusters.begin()) += 1.0;
    }
  }
  const Eigen::MatrixXd either =
      of_box.replicate(1, of_cluster.size()) + of_cluster.replicate(of_box.size(), 1) - shared;
  return shared.cwiseQuotient(either.cwiseMax(1.0));
}

}  // namespace

std::vector<ClusterId> MatchLabels(std::span<const LabelIdentity> labels,
                                   std::span<const int> label_of_node,
                                   std::span<const ClusterId> previous_of_node,
                                   const LabelMatchingOptions& options) {
  CheckInput(labels, label_of_node, previous_of_node);
  std::vector<ClusterId> matched(labels.size());
  for (std::size_t label = 0; label < labels.size(); ++label) {
    if (labels[label].kind == LabelKind::kStatic) matched[label] = kStaticScene;
    if (labels[label].kind == LabelKind::kCluster) matched[label] = labels[label].cluster;
  }
  const std::vector<int> boxes = NewBoxes(labels);
  const std::vector<ClusterId> clusters = CandidateClusters(labels, previous_of_node);
  const Eigen::MatrixXd overlaps = Overlaps(boxes, clusters, label_of_node, previous_of_node);
  const std::vector<int> assigned = Assign(-overlaps);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (assigned[b] < 0 || overlaps(b, assigned[b]) < options.min_iou) continue;
    matched[boxes[b]] = clusters[assigned[b]];
  }
  return matched;
}

}  // namespace cvo
