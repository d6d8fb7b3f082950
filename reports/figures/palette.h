// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// How a variant looks in every figure. Colours are those of Okabe and Ito, which the colour-blind
// tell apart; marks differ too, and lines of a second round of colours are dashed.
struct Style {
  std::string colour;  // "#rrggbb"
  std::string symbol;  // of Plotly's markers
  std::string dash;    // of Plotly's lines
};

// The truth, in every figure.
inline constexpr const char* kTruthColour = "#8a8a8a";
// What lies behind the data: seen on white and on black.
inline constexpr const char* kShade = "rgba(128,128,128,0.18)";

// Variants that come with the program have their own place; what else there is follows in the order
// given.
class Palette {
 public:
  explicit Palette(const std::vector<std::string>& names);

  const Style& Of(const std::string& name) const;

 private:
  std::vector<std::string> names_;
  std::vector<Style> styles_;
};

// The palette of a suite's variants and, after them, of other names.
Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others = {});

// "rgba(r,g,b,opacity)" of "#rrggbb".
std::string Faded(const std::string& colour, double opacity);

}  // namespace cvo::reports
