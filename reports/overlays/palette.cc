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
                                         {60, 95, 250}}};

// Half way to white.
Rgb Tint(Rgb color) {
  const auto half = [](std::uint8_t part) { return static_cast<std::uint8_t>((part + 255) / 2); };
  return {half(color.red), half(color.green), half(color.blue)};
}

}  // namespace

Rgb ClusterColor(std::int64_t id) {
  constexpr std::uint64_t kCount = kColors.size();
  const std::uint64_t place = (static_cast<std::uint64_t>(id) - 1U) % (2U * kCount);
  const Rgb color = kColors[place % kCount];
  return place < kCount ? color : Tint(color);
}

Rgb TextColorOn(Rgb background) {
  const double luma = 0.299 * background.red + 0.587 * background.green + 0.114 * background.blue;
  return luma > 115.0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
}

}  // namespace cvo::reports
