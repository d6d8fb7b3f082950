// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/clustering/crf_scene.h"
#include "core/clustering/unary_options.h"

namespace cvo {

// Nodes by labels, nats.
using EnergyMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A unary term is a policy that writes -log p(label) for every node, up to a constant per node, as
// large as it comes (infinity: impossible). `energies` has the scene's nodes by labels already.
template <typename T>
concept UnaryTerm = requires(const CrfScene& scene, const UnaryOptions& options,
                             EnergyMatrix& energies) {
  T::Energies(scene, options, energies);
};

// Makes each row -log of probabilities that add up to 1, then cuts it off at max_energy
// (METHOD.md 5.2). A row that prefers no label becomes zero, also where all is impossible.
// Throws Error on a row that is no number: a covariance that is none.
void NormalizeEnergies(double max_energy, EnergyMatrix& energies);

// d^T covariance^-1 d; the covariance is positive definite.
inline double MahalanobisSquared(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& d) {
  return covariance.llt().matrixL().solve(d).squaredNorm();
}

// The terms one by one, each normalised and cut off, and their sum.
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
