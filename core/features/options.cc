// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/options.h"

namespace cvo {

void OrbOptions::Check() const {
  CheckRanges(*this);
  if (fast_threshold_min > fast_threshold) {
    ThrowError("option fast_threshold_min", StrCat(fast_threshold_min),
               StrCat("at most fast_threshold (", fast_threshold, ")"));
  }
}

void StereoMatchOptions::Check() const { CheckRanges(*this); }

}  // namespace cvo
