// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/palette.h"

#include <array>

namespace cvo::reports {
namespace {

// Each colour is far from all others (CIE 1976 colour difference of at least 26) and from every
// grey. They are ordered so that consecutive ids differ most. Blue is lighter than usual, since it
// must be visible on dark images.
constexpr std::array<Rgb, kClusterColors> kColors = {{{230, 159, 0},
                                                      {86, 180, 233},
                                                      {0, 190, 130},
                                                      {240, 228, 66},
                                                      {235, 95, 20},
                                                      {225, 130, 195},
                                                      {60, 95, 250},
                                                      {160, 240, 60},
                                                      {170, 90, 240},
                                                      {0, 230, 235},
                                                      {255, 55, 105},
                                                      {255, 195, 160},
                                                      {175, 120, 75},
                                                      {175, 255, 205},
                                                      {195, 185, 255},
                                                      {255, 80, 235}}};

}  // namespace

Rgb ClusterColor(std::int64_t id) {
  return kColors[(static_cast<std::uint64_t>(id) - 1U) % kColors.size()];
}

Rgb TextColorOn(Rgb background) {
  const double luma = 0.299 * background.red + 0.587 * background.green + 0.114 * background.blue;
  return luma > 115.0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
}

}  // namespace cvo::reports
