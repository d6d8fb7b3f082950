// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_2D of section 3.2 of the paper: eta / |C| for the labels in C, (1 - eta) / (M - |C|) for the
// others, C the labels whose detection, shrunk by box_shrink, contains the landmark, and the static
// scene if it is in the lowest box_foot of all of these. Where there are none: the labels whose
// predicted box does (as it is) and the static scene, for the detector's silence neither confirms
// nor denies them; or else the static scene alone (METHOD.md 5.3).
struct Box2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// The same without predictions: outside of all detections the static scene alone, as if a body that
// the detector missed were not there.
struct DetectedBox2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: detections in full size, predictions unknown, and where C is empty all labels are
// equally likely.
struct Box2dTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

}  // namespace cvo
