// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/clustering/crf_scene.h"
#include "core/clustering/unary_options.h"

namespace cvo {

// Nodes (rows) by labels (columns), nats.
using EnergyMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A unary term is a policy that writes -log p(label) for every node, up to a constant per node and
// not capped (infinity: impossible). `energies` already has the size nodes by labels.
template <typename T>
concept UnaryTerm = requires(const CrfScene& scene, const UnaryOptions& options,
                             EnergyMatrix& energies) {
  T::Energies(scene, options, energies);
};

// Normalises each row to -log of probabilities that sum to 1, then caps it at max_energy
// (METHOD.md 5.2). A row that prefers no label becomes zero, even if all labels are impossible.
// Throws Error if a row contains NaN, the sign of an invalid covariance.
void NormalizeEnergies(double max_energy, EnergyMatrix& energies);

// Returns d^T covariance^-1 d. The covariance must be positive definite.
inline double MahalanobisSquared(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& d) {
  return covariance.llt().matrixL().solve(d).squaredNorm();
}

// The three terms, each normalised and capped, and their sum.
struct UnaryEnergies {
  EnergyMatrix total;
  EnergyMatrix box;
  EnergyMatrix affinity;
  EnergyMatrix motion;
};

template <UnaryTerm Term>
EnergyMatrix TermEnergies(const CrfScene& scene, const UnaryOptions& options) {
  EnergyMatrix energies(static_cast<Eigen::Index>(scene.nodes.size()),
                        static_cast<Eigen::Index>(scene.labels.size()));
  Term::Energies(scene, options, energies);
  NormalizeEnergies(options.max_energy, energies);
  return energies;
}

// psi_u of section 3.2 of the paper as an energy: the sum of -log p_2D, -log p_3D and -log p_mot.
template <UnaryTerm Box, UnaryTerm Affinity, UnaryTerm Motion>
UnaryEnergies ComputeUnaries(const CrfScene& scene, const UnaryOptions& options) {
  UnaryEnergies unaries;
  unaries.box = TermEnergies<Box>(scene, options);
  unaries.affinity = TermEnergies<Affinity>(scene, options);
  unaries.motion = TermEnergies<Motion>(scene, options);
  unaries.total = unaries.box + unaries.affinity + unaries.motion;
  return unaries;
}

// A term that prefers no label.
struct SilentTerm {
  static void Energies(const CrfScene&, const UnaryOptions&, EnergyMatrix& energies) {
    energies.setZero();
  }
};

}  // namespace cvo
