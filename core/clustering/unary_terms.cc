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

namespace {

using Boxes = std::vector<std::optional<ImageBox>>;

Boxes BoxesOf(const CrfScene& scene, std::optional<ImageBox> CrfLabel::*box) {
  Boxes boxes;
  boxes.reserve(scene.labels.size());
  for (const CrfLabel& label : scene.labels) boxes.push_back(label.*box);
  return boxes;
}

// The set C of one landmark.
class Candidates {
 public:
  explicit Candidates(std::size_t labels) : holds_(labels, false) {}

  void Clear() {
    holds_.assign(holds_.size(), false);
    count_ = 0;
  }
  void Add(std::size_t label) {
    holds_[label] = true;
    ++count_;
  }
  void AddContaining(const Boxes& boxes, const Eigen::Vector3d& z_px) {
    for (std::size_t l = 0; l < boxes.size(); ++l) {
      if (boxes[l] && boxes[l]->Contains(z_px[0], z_px[1])) Add(l);
    }
  }
  void AddStatic(const CrfScene& scene) {
    for (std::size_t l = 0; l < scene.labels.size(); ++l) {
      if (scene.labels[l].kind == LabelKind::kStatic) Add(l);
    }
  }
  bool Empty() const { return count_ == 0; }

  void Write(double eta, Eigen::Index node, EnergyMatrix& energies) const {
    const double others = static_cast<double>(holds_.size()) - count_;
    const double in = -std::log(eta / count_);
    const double out = -std::log((1.0 - eta) / others);
    for (std::size_t l = 0; l < holds_.size(); ++l) {
      energies(node, static_cast<Eigen::Index>(l)) = holds_[l] ? in : out;
    }
  }

 private:
  std::vector<bool> holds_;
  double count_ = 0.0;
};

// `predicted` holds the boxes to be used where there is no detection.
void BoxEnergies(const CrfScene& scene, const UnaryOptions& options, const Boxes& predicted,
                 EnergyMatrix& energies) {
  const Boxes detected = BoxesOf(scene, &CrfLabel::box);
  Candidates candidates(scene.labels.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Eigen::Vector3d& z_px = scene.nodes[i].z_px;
    candidates.Clear();
    candidates.AddContaining(detected, z_px);
    if (candidates.Empty()) {
      candidates.AddContaining(predicted, z_px);
      candidates.AddStatic(scene);
    }
    candidates.Write(options.eta, static_cast<Eigen::Index>(i), energies);
  }
}

}  // namespace

void Box2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                         EnergyMatrix& energies) {
  BoxEnergies(scene, options, BoxesOf(scene, &CrfLabel::predicted_box), energies);
}

void DetectedBox2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                                 EnergyMatrix& energies) {
  BoxEnergies(scene, options, {}, energies);
}

void Box2dTermLiteral::Energies(const CrfScene& scene, const UnaryOptions& options,
                                EnergyMatrix& energies) {
  const Boxes detected = BoxesOf(scene, &CrfLabel::box);
  Candidates candidates(scene.labels.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    candidates.Clear();
    candidates.AddContaining(detected, scene.nodes[i].z_px);
    if (candidates.Empty()) {
      energies.row(static_cast<Eigen::Index>(i)).setZero();
    } else {
      candidates.Write(options.eta, static_cast<Eigen::Index>(i), energies);
    }
  }
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
