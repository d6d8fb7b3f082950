// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/base/ids.h"

namespace cvo {

// The cluster of a landmark and how sure that is, w of section 3.2 of the paper.
struct LabelState {
  ClusterId cluster;  // invalid: none yet
  int confidence = 1;
};

enum class LabelOutcome { kKept, kChanged, kRemove };

// How a landmark that is seen in the current frame takes the cluster inferred for it, after labels
// were matched with clusters; an invalid id is the outlier class. Outliers cost confidence but are
// nothing that a landmark can be: it is to be removed instead, and the state is as before.
template <typename Policy>
concept ConfidencePolicy = requires(ClusterId inferred, LabelState& state) {
  { Policy::Update(inferred, state) } -> std::same_as<LabelOutcome>;
};

// Policy: w + 1 for the same label, w - 1 for another, which is accepted with w = 1 when w reaches
// 0.
struct CountLabels {
  [[nodiscard]] static LabelOutcome Update(ClusterId inferred, LabelState& state) {
    if (inferred.valid() && inferred == state.cluster) {
      ++state.confidence;
      return LabelOutcome::kKept;
    }
    if (state.confidence > 1) {
      --state.confidence;
      return LabelOutcome::kKept;
    }
    if (!inferred.valid()) return LabelOutcome::kRemove;
    state = {inferred, 1};
    return LabelOutcome::kChanged;
  }
};

// Policy: no memory, what was inferred last.
struct TakeLabelsAtOnce {
  [[nodiscard]] static LabelOutcome Update(ClusterId inferred, LabelState& state) {
    if (!inferred.valid()) return LabelOutcome::kRemove;
    const bool is_same = inferred == state.cluster;
    state = {inferred, 1};
    return is_same ? LabelOutcome::kKept : LabelOutcome::kChanged;
  }
};

}  // namespace cvo
