// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/motion_term.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cvo {
namespace {

// The label's transform to the past camera frame; null if its motion since then is unknown.
const RigidTransform* PastFromNow(const CrfLabel& label, int frame) {
  if (label.kind == LabelKind::kNewBox || label.kind == LabelKind::kOutlier) return nullptr;
  if (frame < 0 || static_cast<std::size_t>(frame) >= label.past_from_now.size()) return nullptr;
  const auto& pose = label.past_from_now[static_cast<std::size_t>(frame)];
  return pose ? &*pose : nullptr;
}

bool AnyLabelHasPose(const CrfScene& scene, int frame) {
  return std::any_of(scene.labels.begin(), scene.labels.end(), [frame](const CrfLabel& label) {
    return PastFromNow(label, frame) != nullptr;
  });
}

// Writes the rows of nodes with a past frame in which some label has a pose; all others are zero.
template <typename LabelEnergy>
void EnergiesOfNodesWithPast(const CrfScene& scene, const LabelEnergy& label_energy,
                             EnergyMatrix& energies) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const CrfNode& node = scene.nodes[i];
    auto row = energies.row(static_cast<Eigen::Index>(i));
    if (!node.past || !AnyLabelHasPose(scene, node.past->frame)) {
      row.setZero();
      continue;
    }
    for (std::size_t l = 0; l < scene.labels.size(); ++l) {
      row[static_cast<Eigen::Index>(l)] = label_energy(node, scene.labels[l]);
    }
  }
}

}  // namespace

void MotionTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                          EnergyMatrix& energies) {
  const auto label_energy = [&](const CrfNode& node, const CrfLabel& label) {
    if (label.kind == LabelKind::kOutlier) return options.outlier_motion;
    const RigidTransform* past_from_now = PastFromNow(label, node.past->frame);
    if (past_from_now == nullptr) return options.neutral_motion;
    const CrfNode::Place place = node.MovingPlace();
    const Eigen::Vector3d p_in_past = *past_from_now * place.p_in_camera;
    const auto z_px = scene.camera.Project(p_in_past);
    if (!z_px) return 0.5 * options.motion_cap;
    const Eigen::Matrix3d J =
        scene.camera.ProjectionJacobian(p_in_past) * past_from_now->RotationMatrix();
    const Eigen::Matrix3d S = node.past->covariance_px2 + J * place.covariance_m2 * J.transpose();
    return 0.5 * std::min(MahalanobisSquared(S, node.past->z_px - *z_px), options.motion_cap);
  };
  EnergiesOfNodesWithPast(scene, label_energy, energies);
}

void MotionTermLiteral::Energies(const CrfScene& scene, const UnaryOptions&,
                                 EnergyMatrix& energies) {
  const auto label_energy = [&](const CrfNode& node, const CrfLabel& label) {
    const RigidTransform* past_from_now = PastFromNow(label, node.past->frame);
    if (past_from_now == nullptr) return 0.0;
    const auto z_px = scene.camera.Project(*past_from_now * node.MovingPlace().p_in_camera);
    if (!z_px) return std::numeric_limits<double>::infinity();
    return MahalanobisSquared(node.past->covariance_px2, node.past->z_px - *z_px) +
           0.5 * std::log(node.past->covariance_px2.determinant());
  };
  EnergiesOfNodesWithPast(scene, label_energy, energies);
}

}  // namespace cvo
