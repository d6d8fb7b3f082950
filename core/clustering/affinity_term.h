// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_3D as METHOD.md 5.4 has it: -log p = d^T (Sigma_Z + kappa^2 R diag(l^2) R^T)^-1 d / 2 with d
// from the body's centre to the landmark, in the camera frame; no determinant. Less
// undetected_reach^2 / 2, but not below 0, for a body without a detection. static_energy and
// outlier_energy for those two classes; a body of unknown extent is no nearer than the static
// scene.
struct AffinityTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: -log p = d^T Sigma_Z^-1 d / l^2, with l in metres the mean of the half sizes. The
// paper has no values for classes without a centre: those of AffinityTerm.
struct AffinityTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// Labels compared without regard to where they are in space.
struct NoAffinityTerm : SilentTerm {};

}  // namespace cvo
