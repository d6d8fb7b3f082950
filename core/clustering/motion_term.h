// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_mot as METHOD.md 5.5 has it: -log p = min(e^T S^-1 e, motion_cap) / 2, e from where the body
// says the landmark was seen in the past frame to where it was, S = Sigma_z + J R Sigma_Z R^T J^T.
// Behind the past camera: the cap. No motion known then, or a new box: neutral_motion; the outlier
// class: outlier_motion. All equal where the landmark has no past or no label has a pose then.
struct MotionTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: exp(-e^T Sigma_z^-1 e) / sqrt|Sigma_z|, and the factor 1 for a label without a pose
// in that frame. The paper's factor for the current frame has e = 0 whatever the label: left out.
// Behind the past camera, where the formula has no meaning: impossible.
struct MotionTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// Labels compared without regard to how they move.
struct NoMotionTerm : SilentTerm {};

}  // namespace cvo
