// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// The look of a variant, which is the same in every figure. Colours are those of Okabe and Ito,
// which colour-blind people can tell apart. Symbols differ as well, and lines are dashed once the
// colours repeat.
struct Style {
  std::string colour;  // "#rrggbb"
  std::string symbol;  // name of a Plotly marker
  std::string dash;    // name of a Plotly line style
};

// The colour of the truth in every figure.
inline constexpr const char* kTruthColour = "#8a8a8a";
// The colour of shading behind the data. It is visible on white and on black.
inline constexpr const char* kShade = "rgba(128,128,128,0.18)";

// Assigns a style to each name. Variants that ship with the program have a fixed style; all other
// names get the remaining styles in the order given.
class Palette {
 public:
  explicit Palette(const std::vector<std::string>& names);

  const Style& Of(const std::string& name) const;

 private:
  std::vector<std::string> names_;
  std::vector<Style> styles_;
};

// The palette of the variants of a suite, followed by other names.
Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others = {});

// Converts "#rrggbb" to "rgba(r,g,b,opacity)".
std::string Faded(const std::string& colour, double opacity);

}  // namespace cvo::reports
