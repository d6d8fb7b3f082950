// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiments/metrics/object_scores.h"

namespace cvo {

// Variant against variant: a body's position errors of two runs, root mean squares over the frames
// that both estimate. Each run keeps the object_from_gtobject of all its own frames.
struct PairedBody {
  int id = 0;
  int frames = 0;
  double ate_a_m = 0.0;
  double ate_b_m = 0.0;
};
// Movers with at least one such frame, by id; what a bootstrap over bodies draws from.
std::vector<PairedBody> PairBodies(const std::vector<BodyScore>& a,
                                   const std::vector<BodyScore>& b);

// Means over bodies; empty without any.
struct PairedAte {
  int bodies = 0;
  int frames = 0;
  double ate_a_m = 0.0;
  double ate_b_m = 0.0;
};
[[nodiscard]] std::optional<PairedAte> MeanPairedAte(const std::vector<PairedBody>& pairs);

}  // namespace cvo
