// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/chart/chart.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Numbers, texts and looks, the same in all figures and pages.

// A number for sentences: `digits` significant digits, no exponent.
std::string NumberText(double value, int digits = 3);

// How figures show a metric: shares in percent, lengths in m, cm or mm, angles in degrees.
struct Shown {
  double scale = 1.0;
  std::string unit;  // empty: a count
  bool is_share = false;

  // "1.2 cm"; "3" for a count.
  std::string Text(double value) const;
};
// `largest`: magnitude of the values, which decides between m, cm and mm.
Shown ShownAs(const Column& column, double largest);

// "object ATE (cm)".
std::string AxisTitle(const Column& column, const Shown& shown);

// Whether a figure draws the cell. Events of bodies are not drawn of a row that finds no body: it
// has none, but is not good.
bool IsDrawn(const Table& table, const Row& row, std::size_t column);

// Describes for a title how metrics are measured. Metrics that are measured alike are listed
// together: "object ATE: aligned in the world frame by the camera; camera T.RPE: delta all, not
// aligned". Empty for shares and counts.
std::string RelationText(const std::vector<const Column*>& columns);

// Makes the first letter upper case.
std::string Capitalised(std::string text);

// Reduces a text to lower-case letters, digits and "-", for file names. At most 80 characters.
std::string Slug(const std::string& text);

// Gives each name a look of its own, in the order given: colour and symbol, and dashes once the
// colours repeat.
class Palette {
 public:
  explicit Palette(const std::vector<std::string>& names);

  // Look without a symbol, for lines, and with one, for points.
  Look Line(const std::string& name, double width = 1.2) const;
  Look Points(const std::string& name) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace cvo::reports
