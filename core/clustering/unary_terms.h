// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/clustering/crf_options.h"
#include "core/clustering/dense_crf.h"

namespace cvo {

using EnergyMatrix = CrfMatrix;  // nats

// A unary term is a policy that writes -log p(label) for every node, up to a constant per node and
// not capped (infinity: impossible). `energies` already has the size nodes by labels.

// Normalises each row to -log of probabilities that sum to 1, then caps it at max_energy
// (METHOD.md 5.2). A row that prefers no label becomes zero, even if all labels are impossible.
// Throws Error if a row contains NaN, the sign of an invalid covariance.
void NormalizeEnergies(double max_energy, EnergyMatrix& energies);

// Returns d^T covariance^-1 d. The covariance must be positive definite.
inline double MahalanobisSquared(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& d) {
  return covariance.llt().matrixL().solve(d).squaredNorm();
}

template <typename Term>
EnergyMatrix TermEnergies(const CrfScene& scene, const UnaryOptions& options) {
  EnergyMatrix energies(static_cast<Eigen::Index>(scene.nodes.size()),
                        static_cast<Eigen::Index>(scene.labels.size()));
  Term::Energies(scene, options, energies);
  NormalizeEnergies(options.kMaxEnergy, energies);
  return energies;
}

// psi_u (Eq. 5 of the paper) as an energy: the sum of the terms, each normalised and capped.
template <typename... Terms>
EnergyMatrix ComputeUnaries(const CrfScene& scene, const UnaryOptions& options) {
  return (... + TermEnergies<Terms>(scene, options));
}

// A term that prefers no label: labels do not depend on the distance from the centres of bodies, or
// on their motion.
struct NoTerm {
  static void Energies(const CrfScene&, const UnaryOptions&, EnergyMatrix& energies) {
    energies.setZero();
  }
};

// p_3D (Eq. 7; METHOD.md 5.4): -log p = d^T (Sigma_Z + kappa^2 R diag(l^2) R^T)^-1 d / 2, where d
// points from the body's centre to the landmark, in the camera frame; the determinant is left out.
// For a body without a detection the energy is lower by undetected_reach^2 / 2, but not below 0.
// The static scene and any body of unknown extent have static_energy, the outlier class
// outlier_energy.
struct AffinityTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: -log p = d^T Sigma_Z^-1 d / l^2, where l is the mean of the half sizes in metres. The
// paper gives no values for classes without a centre; they have those of AffinityTerm.
struct AffinityTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// p_2D (Eq. 6): eta / |C| for the labels in C, (1 - eta) / (M - |C|) for the
// others. C consists of the labels whose detection contains the landmark. If none does, C consists
// of the static scene and the labels whose predicted box contains it: a missed detection is no
// evidence for or against them (METHOD.md 5.3).
struct Box2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// The same without predicted boxes: outside all detections, C is the static scene alone, as if a
// body that the detector missed were not there.
struct DetectedBox2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: predicted boxes are not used, and all labels are equally likely if C is empty.
struct Box2dTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// p_mot (Eq. 8; METHOD.md 5.5): -log p = min(e^T S^-1 e, motion_cap) / 2 with
// S = Sigma_z + J R Sigma_Z R^T J^T, where e is the landmark's past observation minus the one
// predicted from the motion of the body. A point behind the past camera costs motion_cap / 2. New
// boxes and bodies without a pose in the current or past frame cost neutral_motion, the outlier
// class outlier_motion. All labels cost the same if the landmark has no past or no label has a pose
// in the past frame.
struct MotionTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

}  // namespace cvo
