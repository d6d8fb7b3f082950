// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

namespace cvo {

// Patch of the left image around a corner, at the pyramid level of the corner.
struct FeaturePatch {
  static constexpr int kRadius_px = 9;
  static constexpr int kSide_px = 2 * kRadius_px + 1;

  std::array<std::uint8_t, kSide_px * kSide_px> pixels{};  // row-major
  // Sub-pixel offset of the corner from the centre of the middle pixel, px of the level.
  float corner_u = 0.0F;
  float corner_v = 0.0F;
};

// Aligns `reference` with `seen` (METHOD.md 3.4). Returns the shift from the corner of `seen` to
// the point that is the corner of `reference`, in px of the level of `seen`. `zoom` is the
// magnification of the surroundings of that point from `reference` to `seen`, each measured in
// pixels of its level. Empty if the alignment does not converge, the patches differ too much, or
// the shift is too large.
[[nodiscard]] std::optional<Eigen::Vector2d> AlignFeaturePatch(const FeaturePatch& reference,
                                                               const FeaturePatch& seen,
                                                               double zoom);

}  // namespace cvo
