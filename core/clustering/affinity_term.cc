// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/affinity_term.h"

#include <algorithm>

namespace cvo {
namespace {

double EnergyWithoutExtent(LabelKind kind, const UnaryOptions& options) {
  return kind == LabelKind::kOutlier ? options.outlier_energy : options.static_energy;
}

// kappa^2 R diag(l^2) R^T.
Eigen::Matrix3d SpreadOf(const CrfLabel::Extent& extent, double kappa) {
  const Eigen::Matrix3d scaled =
      extent.camera_from_axes * (kappa * extent.half_size_m).asDiagonal();
  return scaled * scaled.transpose();
}

}  // namespace

void AffinityTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                            EnergyMatrix& energies) {
  for (std::size_t l = 0; l < scene.labels.size(); ++l) {
    auto column = energies.col(static_cast<Eigen::Index>(l));
    const auto& extent = scene.labels[l].extent;
    if (!extent) {
      column.setConstant(EnergyWithoutExtent(scene.labels[l].kind, options));
      continue;
    }
    const Eigen::Matrix3d spread = SpreadOf(*extent, options.kappa);
    const double free_reach = scene.labels[l].box ? 0.0 : options.undetected_reach;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      const CrfNode& node = scene.nodes[i];
      const double distance_squared = MahalanobisSquared(
          node.covariance_m2 + spread, node.p_in_camera - extent->center_in_camera);
      column[static_cast<Eigen::Index>(i)] =
          0.5 * std::max(0.0, distance_squared - free_reach * free_reach);
    }
  }
}

void AffinityTermLiteral::Energies(const CrfScene& scene, const UnaryOptions& options,
                                   EnergyMatrix& energies) {
  for (std::size_t l = 0; l < scene.labels.size(); ++l) {
    auto column = energies.col(static_cast<Eigen::Index>(l));
    const auto& extent = scene.labels[l].extent;
    if (!extent) {
      column.setConstant(EnergyWithoutExtent(scene.labels[l].kind, options));
      continue;
    }
    const double size_m = extent->half_size_m.mean();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      const CrfNode& node = scene.nodes[i];
      column[static_cast<Eigen::Index>(i)] =
          MahalanobisSquared(node.covariance_m2, node.p_in_camera - extent->center_in_camera) /
          (size_m * size_m);
    }
  }
}

}  // namespace cvo
