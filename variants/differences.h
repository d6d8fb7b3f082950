// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

namespace cvo {

// In how many axes two variants differ. An ablation that misspells its axis differs in none.
template <typename A, typename B>
constexpr int CountDifferences() {
  return !std::is_same_v<typename A::Detections, typename B::Detections> +
         !std::is_same_v<typename A::LandmarkAssociation, typename B::LandmarkAssociation> +
         !std::is_same_v<typename A::BoxWeights, typename B::BoxWeights> +
         !std::is_same_v<typename A::BoxRematch, typename B::BoxRematch> +
         !std::is_same_v<typename A::Rotation, typename B::Rotation> +
         !std::is_same_v<typename A::BoxTerm, typename B::BoxTerm> +
         !std::is_same_v<typename A::AffinityTerm, typename B::AffinityTerm> +
         !std::is_same_v<typename A::MotionTerm, typename B::MotionTerm> +
         !std::is_same_v<typename A::Pairwise, typename B::Pairwise> +
         !std::is_same_v<typename A::Confidence, typename B::Confidence> +
         !std::is_same_v<typename A::MotionPrior, typename B::MotionPrior> +
         !std::is_same_v<typename A::MarginalizationRule, typename B::MarginalizationRule> +
         !std::is_same_v<typename A::Gauge, typename B::Gauge> +
         !std::is_same_v<typename A::SpatialTrack, typename B::SpatialTrack> +
         !std::is_same_v<typename A::Calibration, typename B::Calibration>;
}

}  // namespace cvo
