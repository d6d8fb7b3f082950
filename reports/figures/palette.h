// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/chart/chart.h"

namespace cvo::reports {

// Gives each name a look that is the same in every figure: colour and symbol, and dashes once the
// colours repeat. Variants that ship with the program have a fixed look; all other names get the
// remaining ones in the order given.
class Palette {
 public:
  explicit Palette(const std::vector<std::string>& names);

  // Look without a symbol, for lines, and with one, for points.
  Look Line(const std::string& name, double width = 1.2) const;
  Look Points(const std::string& name) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> places_;  // in the order of all looks
};

}  // namespace cvo::reports
