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
    if (label.kind == LabelKind::kOutlier) return kOutlierMotion;
    const RigidTransform* past_from_now = PastFromNow(label, node.past->frame);
    if (past_from_now == nullptr) return kNeutralMotion;
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
