// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/palette.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Variants with a fixed look. The most used come first, since the first ones never share a colour.
constexpr std::array kKnown = {"full",
                               "2d",
                               "2d3d",
                               "no_gp_prior",
                               "static",
                               "no_pairwise",
                               "no_turn_prior",
                               "no_spatial_track",
                               "no_marginalization",
                               "no_probabilistic_association",
                               "no_box_rematch",
                               "no_label_confidence",
                               "clustervo",
                               "no_identity"};

std::size_t KnownPlace(const std::string& name) {
  return static_cast<std::size_t>(std::find(kKnown.begin(), kKnown.end(), name) - kKnown.begin());
}

}  // namespace

Palette::Palette(const std::vector<std::string>& names) {
  std::vector<std::size_t> taken;
  for (const std::string& name : names) taken.push_back(KnownPlace(name));
  std::size_t next = 0;
  for (const std::string& name : names) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) continue;
    names_.push_back(name);
    std::size_t place = KnownPlace(name);
    if (place == kKnown.size()) {
      while (std::find(taken.begin(), taken.end(), next) != taken.end()) ++next;
      place = next++;
    }
    places_.push_back(place);
  }
}

Look Palette::Line(const std::string& name, double width) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  Require(found != names_.end(), "Palette: a name that it was not made for");
  const auto place = static_cast<int>(places_[static_cast<std::size_t>(found - names_.begin())]);
  constexpr int kDashes = 4;
  return {1 + place % kChartColours, Symbol::kNone, place / kChartColours % kDashes, width};
}

Look Palette::Points(const std::string& name) const {
  Look look = Line(name);
  const int place = look.colour - 1 + kChartColours * look.dash;
  constexpr int kSymbols = 8;
  look.symbol = static_cast<Symbol>(1 + (place + look.dash) % kSymbols);
  return look;
}

}  // namespace cvo::reports
