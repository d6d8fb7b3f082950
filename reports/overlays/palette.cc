// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/palette.h"

#include <array>

namespace cvo::reports {
namespace {

// Ordered so that ids that follow each other differ most; blue is lighter than usual, since it must
// be seen on dark images.
constexpr std::array<Rgb, 7> kColors = {{{230, 159, 0},
                                         {86, 180, 233},
                                         {0, 190, 130},
                                         {240, 228, 66},
                                         {235, 95, 20},
                                         {225, 130, 195},
                                         {60, 130, 240}}};

}  // namespace

Rgb ClusterColor(std::int64_t id) {
  constexpr auto kCount = static_cast<std::int64_t>(kColors.size());
  const std::int64_t index = ((id - 1) % kCount + kCount) % kCount;  // of id 1: the first
  return kColors[static_cast<std::size_t>(index)];
}

Rgb TextColorOn(Rgb background) {
  const double luma = 0.299 * background.red + 0.587 * background.green + 0.114 * background.blue;
  return luma > 115.0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
}

}  // namespace cvo::reports
