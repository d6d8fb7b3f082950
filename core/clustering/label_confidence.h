// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/base/ids.h"

namespace cvo {

// The cluster of a landmark and the confidence w in it (section 3.2 of the paper).
struct LabelState {
  ClusterId cluster;  // invalid: none yet
  int confidence = 1;
};

enum class LabelOutcome { kKept, kChanged, kRemove };

// How a landmark seen in the current frame adopts the cluster inferred for it, after labels were
// matched with clusters; an invalid id is the outlier class. An outlier label lowers the confidence
// but is never adopted: instead, kRemove is returned and the state stays as it was.
template <typename Policy>
concept ConfidencePolicy = requires(ClusterId inferred, LabelState& state) {
  { Policy::Update(inferred, state) } -> std::same_as<LabelOutcome>;
};

// Policy: w + 1 for the same label, w - 1 for another one, which is adopted with w = 1 when w
// reaches 0.
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

// Policy: the label inferred last is adopted, without memory.
struct TakeLabelsAtOnce {
  [[nodiscard]] static LabelOutcome Update(ClusterId inferred, LabelState& state) {
    if (!inferred.valid()) return LabelOutcome::kRemove;
    const bool is_same = inferred == state.cluster;
    state = {inferred, 1};
    return is_same ? LabelOutcome::kKept : LabelOutcome::kChanged;
  }
};

}  // namespace cvo
