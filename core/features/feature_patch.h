// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

namespace cvo {

// The left image around a corner, at the corner's pyramid level.
struct FeaturePatch {
  static constexpr int kRadius_px = 9;
  static constexpr int kSide_px = 2 * kRadius_px + 1;

  std::array<std::uint8_t, kSide_px * kSide_px> pixels{};  // row by row
  // Of the corner from the centre of the middle pixel, px of the level.
  float corner_u = 0.0F;
  float corner_v = 0.0F;
};

// Where `seen` shows the point that is the corner of `reference`, as a shift from seen's own
// corner, px of its level (METHOD.md 3.4). `zoom`: how much larger, in pixels of the levels, the
// point's surroundings are in `seen`. Empty where the patches do not look alike, or the shift is
// too large. Uses AVX2 where there is.
[[nodiscard]] std::optional<Eigen::Vector2d> AlignFeaturePatch(const FeaturePatch& reference,
                                                               const FeaturePatch& seen,
                                                               double zoom);

// The same without AVX2: what the fast path is tested against.
[[nodiscard]] std::optional<Eigen::Vector2d> AlignFeaturePatchPlain(const FeaturePatch& reference,
                                                                    const FeaturePatch& seen,
                                                                    double zoom);

}  // namespace cvo
