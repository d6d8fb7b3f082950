// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/unary_terms.h"

namespace cvo {

// p_2D of section 3.2 of the paper: eta / |C| for the labels in C, (1 - eta) / (M - |C|) for the
// others. C consists of the labels whose detection, shrunk by box_shrink, contains the landmark,
// and of the static scene if the landmark is in the lowest box_foot of all these detections. If no
// detection contains it, C consists of the static scene and the labels whose predicted box, not
// shrunk, contains it: a missed detection is no evidence for or against them (METHOD.md 5.3).
struct Box2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// The same without predicted boxes: outside all detections, C is the static scene alone, as if a
// body that the detector missed were not there.
struct DetectedBox2dTerm {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

// As printed: detections are not shrunk, predicted boxes are not used, and all labels are equally
// likely if C is empty.
struct Box2dTermLiteral {
  static void Energies(const CrfScene& scene, const UnaryOptions& options, EnergyMatrix& energies);
};

}  // namespace cvo
