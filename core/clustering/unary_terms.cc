// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/unary_terms.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace cvo {

namespace {

// Motion term of a class without a known motion: mean of chi^2 / 2 with 3 degrees of freedom
// (METHOD.md 5.5).
constexpr double kNeutralMotion = 1.5;
// Motion term of the outlier class: half of 9 (METHOD.md 5.5).
constexpr double kOutlierMotion = 4.5;

// Writes energy(node, label) for the labels with an extent, and the energies of the other classes.
void ExtentEnergies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies,
                    const auto& energy_of) {
  for (std::size_t l = 0; l < scene.labels.size(); ++l) {
    const CrfLabel& label = scene.labels[l];
    auto column = energies.col(static_cast<Eigen::Index>(l));
    if (!label.extent) {
      column.setConstant(label.kind == LabelKind::kOutlier ? options.outlier_energy
                                                           : options.static_energy);
      continue;
    }
    const auto energy = energy_of(label);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      column[static_cast<Eigen::Index>(i)] = energy(scene.nodes[i]);
    }
  }
}

}  // namespace

void AffinityTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                            EnergyMatrix& energies) {
  ExtentEnergies(scene, options, energies, [&](const CrfLabel& label) {
    const CrfLabel::Extent& extent = *label.extent;
    const Eigen::Matrix3d scaled =
        extent.camera_from_axes * (options.kappa * extent.half_size_m).asDiagonal();
    const Eigen::Matrix3d spread = scaled * scaled.transpose();  // kappa^2 R diag(l^2) R^T
    const double free_reach = label.box ? 0.0 : options.undetected_reach;
    return [&extent, spread, free_reach](const CrfNode& node) {
      const double distance_squared = MahalanobisSquared(
          node.covariance_m2 + spread, node.p_in_camera - extent.center_in_camera);
      return 0.5 * std::max(0.0, distance_squared - free_reach * free_reach);
    };
  });
}

void AffinityTermLiteral::Energies(const CrfScene& scene, const UnaryOptions& options,
                                   EnergyMatrix& energies) {
  ExtentEnergies(scene, options, energies, [](const CrfLabel& label) {
    const CrfLabel::Extent& extent = *label.extent;
    const double size_m = extent.half_size_m.mean();
    return [&extent, size_m](const CrfNode& node) {
      return MahalanobisSquared(node.covariance_m2, node.p_in_camera - extent.center_in_camera) /
             (size_m * size_m);
    };
  });
}

namespace {

// The set C of a landmark: the labels whose detections contain it; also the static scene, if none
// does; also the undetected clusters expected there.
enum class Candidates { kDetected, kOrStatic, kOrPredicted };

void BoxEnergies(const CrfScene& scene, const UnaryOptions& options, Candidates candidates,
                 EnergyMatrix& energies) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Eigen::Vector3d& z_px = scene.nodes[i].z_px;
    const auto contains = [&](const std::optional<ImageBox>& box) {
      return box && box->Contains(z_px[0], z_px[1]);
    };
    const bool is_detected = std::ranges::any_of(scene.labels, contains, &CrfLabel::box);
    const auto is_candidate = [&](const CrfLabel& label) {
      if (contains(label.box)) return true;
      if (label.kind == LabelKind::kStatic)
        return !is_detected && candidates != Candidates::kDetected;
      return candidates == Candidates::kOrPredicted && contains(label.predicted_box);
    };
    const double count =
        static_cast<double>(std::ranges::count_if(scene.labels, is_candidate));  // |C|
    const double others = static_cast<double>(scene.labels.size()) - count;
    const double in = -std::log(options.eta / count);
    const double out = -std::log((1.0 - options.eta) / others);
    for (std::size_t l = 0; l < scene.labels.size(); ++l) {
      energies(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(l)) =
          is_candidate(scene.labels[l]) ? in : out;
    }
  }
}

}  // namespace

void Box2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                         EnergyMatrix& energies) {
  BoxEnergies(scene, options, Candidates::kOrPredicted, energies);
}

void DetectedBox2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                                 EnergyMatrix& energies) {
  BoxEnergies(scene, options, Candidates::kOrStatic, energies);
}

void Box2dTermLiteral::Energies(const CrfScene& scene, const UnaryOptions& options,
                                EnergyMatrix& energies) {
  BoxEnergies(scene, options, Candidates::kDetected, energies);
}

namespace {

// Whether the motion of the label since the past frame is known.
bool HasMotion(const CrfLabel& label) {
  const bool can_move = label.kind == LabelKind::kStatic || label.kind == LabelKind::kCluster;
  return can_move && label.past_from_now.has_value();
}

double MotionEnergy(const CrfScene& scene, const UnaryOptions& options, const CrfNode& node,
                    const CrfLabel& label) {
  if (label.kind == LabelKind::kOutlier) return kOutlierMotion;
  if (!HasMotion(label)) return kNeutralMotion;
  const CrfNode::Place place = node.MovingPlace();
  const Eigen::Vector3d p_in_past = *label.past_from_now * place.p_in_camera;
  const auto z_px = scene.camera.Project(p_in_past);
  if (!z_px) return 0.5 * options.motion_cap;
  const Eigen::Matrix3d J =
      scene.camera.ProjectionJacobian(p_in_past) * label.past_from_now->RotationMatrix();
  const Eigen::Matrix3d S = node.past->covariance_px2 + J * place.covariance_m2 * J.transpose();
  return 0.5 * std::min(MahalanobisSquared(S, node.past->z_px - *z_px), options.motion_cap);
}

}  // namespace

void MotionTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                          EnergyMatrix& energies) {
  energies.setZero();
  if (std::none_of(scene.labels.begin(), scene.labels.end(), HasMotion)) return;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].past) continue;
    for (std::size_t l = 0; l < scene.labels.size(); ++l) {
      energies(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(l)) =
          MotionEnergy(scene, options, scene.nodes[i], scene.labels[l]);
    }
  }
}

void NormalizeEnergies(double max_energy, EnergyMatrix& energies) {
  if (energies.cols() == 0) return;
  for (Eigen::Index i = 0; i < energies.rows(); ++i) {
    auto row = energies.row(i);
    const double least = row.minCoeff();
    if (least == row.maxCoeff()) {
      row.setZero();
      continue;
    }
    double sum = 0.0;
    for (const double energy : row) sum += std::exp(least - energy);
    if (!(sum >= 1.0)) {
      ThrowError(StrCat("unary energies, node ", i), StrCat(row), "numbers: is a covariance bad?");
    }
    const double log_sum = std::log(sum);
    for (double& energy : row) energy = std::min(energy - least + log_sum, max_energy);
  }
}

}  // namespace cvo
