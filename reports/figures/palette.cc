// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/palette.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Variants with a fixed style, so that they look the same in every suite. The most used come first,
// since the first ones never share a colour.
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

constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#a0892c", "#7a5195"};
constexpr std::array kSymbols = {"circle", "square",        "diamond", "triangle-up",
                                 "cross",  "triangle-down", "star",    "hexagon"};
constexpr std::array kDashes = {"solid", "dash", "dashdot", "longdash"};

Style StyleAt(std::size_t place) {
  return {kColours[place % kColours.size()],
          kSymbols[(place + place / kSymbols.size()) % kSymbols.size()],
          kDashes[place / kColours.size() % kDashes.size()]};
}

int Hex(const std::string& text, std::size_t at) {
  return std::stoi(text.substr(at, 2), nullptr, 16);
}

}  // namespace

Palette::Palette(const std::vector<std::string>& names) {
  std::vector<std::size_t> taken;
  for (const std::string& name : names) {
    const auto known = std::find(kKnown.begin(), kKnown.end(), name);
    if (known != kKnown.end()) taken.push_back(static_cast<std::size_t>(known - kKnown.begin()));
  }
  std::size_t next = 0;
  for (const std::string& name : names) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) continue;
    const auto known = std::find(kKnown.begin(), kKnown.end(), name);
    names_.push_back(name);
    if (known != kKnown.end()) {
      styles_.push_back(StyleAt(static_cast<std::size_t>(known - kKnown.begin())));
      continue;
    }
    while (std::find(taken.begin(), taken.end(), next) != taken.end()) ++next;
    styles_.push_back(StyleAt(next++));
  }
}

const Style& Palette::Of(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  Require(found != names_.end(), "Palette: a name that it was not made for");
  return styles_[static_cast<std::size_t>(found - names_.begin())];
}

Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const PlannedRun& run : plan.runs) names.push_back(KeyOf(run, "variant"));
  names.insert(names.end(), others.begin(), others.end());
  return Palette(names);
}

std::string Faded(const std::string& colour, double opacity) {
  return StrCat("rgba(", Hex(colour, 1), ",", Hex(colour, 3), ",", Hex(colour, 5), ",", opacity,
                ")");
}

}  // namespace cvo::reports
