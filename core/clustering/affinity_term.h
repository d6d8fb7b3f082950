// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_3D as in METHOD.md 5.4: -log p = d^T (Sigma_Z + kappa^2 R diag(l^2) R^T)^-1 d / 2, where d
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

// No term: labels do not depend on the distance from the centres of bodies.
struct NoAffinityTerm : SilentTerm {};

}  // namespace cvo
