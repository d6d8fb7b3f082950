// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/box_term.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

using Boxes = std::vector<std::optional<ImageBox>>;

Boxes DetectedBoxes(const CrfScene& scene, double shrink) {
  Boxes boxes;
  boxes.reserve(scene.labels.size());
  for (const CrfLabel& label : scene.labels) {
    boxes.push_back(label.box);
    if (label.box) boxes.back() = label.box->Shrunk(shrink);
  }
  return boxes;
}

// The boxes without their lower part, where the ground is visible.
Boxes WithoutBoxFoot(const Boxes& boxes, double foot) {
  Boxes bodies = boxes;
  for (auto& box : bodies) {
    if (box) box->bottom_px -= foot * box->Height();
  }
  return bodies;
}

Boxes PredictedBoxes(const CrfScene& scene) {
  Boxes boxes;
  boxes.reserve(scene.labels.size());
  for (const CrfLabel& label : scene.labels) boxes.push_back(label.predicted_box);
  return boxes;
}

bool AnyContains(const Boxes& boxes, const Eigen::Vector3d& z_px) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const auto& box) { return box && box->Contains(z_px[0], z_px[1]); });
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
  const Boxes detected = DetectedBoxes(scene, options.box_shrink);
  const Boxes bodies = WithoutBoxFoot(detected, options.box_foot);
  Candidates candidates(scene.labels.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Eigen::Vector3d& z_px = scene.nodes[i].z_px;
    candidates.Clear();
    candidates.AddContaining(detected, z_px);
    if (candidates.Empty()) candidates.AddContaining(predicted, z_px);
    if (!AnyContains(bodies, z_px)) candidates.AddStatic(scene);
    candidates.Write(options.eta, static_cast<Eigen::Index>(i), energies);
  }
}

}  // namespace

void Box2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                         EnergyMatrix& energies) {
  BoxEnergies(scene, options, PredictedBoxes(scene), energies);
}

void DetectedBox2dTerm::Energies(const CrfScene& scene, const UnaryOptions& options,
                                 EnergyMatrix& energies) {
  BoxEnergies(scene, options, {}, energies);
}

void Box2dTermLiteral::Energies(const CrfScene& scene, const UnaryOptions& options,
                                EnergyMatrix& energies) {
  const Boxes detected = DetectedBoxes(scene, 0.0);
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

}  // namespace cvo
