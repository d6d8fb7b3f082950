// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_mot as in METHOD.md 5.5: -log p = min(e^T S^-1 e, motion_cap) / 2 with
// S = Sigma_z + J R Sigma_Z R^T J^T, where e is the landmark's past observation minus the one
// predicted from the motion of the body. A point behind the past camera costs motion_cap / 2. New
// boxes and bodies without a pose in the current or past frame cost neutral_motion, the outlier
// class outlier_motion. All labels cost the same if the landmark has no past or no label has a pose
// in the past frame.
struct MotionTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: exp(-e^T Sigma_z^-1 e) / sqrt|Sigma_z|, and the factor 1 for labels without a pose in
// the past frame, new boxes and outliers. The paper's factor for the current frame is left out, as
// e = 0 there for every label. A label that puts the point behind the past camera, where the
// formula has no meaning, is impossible.
struct MotionTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// No term: labels do not depend on the motion of bodies.
struct NoMotionTerm : SilentTerm {};

}  // namespace cvo
