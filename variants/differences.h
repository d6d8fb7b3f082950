// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

namespace cvo {

// In how many axes two variants differ. An ablation that misspells its axis differs in none.
template <typename A, typename B>
constexpr int CountDifferences() {
  return !std::is_same_v<typename A::MarginalizationRule, typename B::MarginalizationRule> +
         !std::is_same_v<typename A::Gauge, typename B::Gauge> +
         !std::is_same_v<typename A::SpatialTrack, typename B::SpatialTrack> +
         !std::is_same_v<typename A::Calibration, typename B::Calibration>;
}

}  // namespace cvo
