// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/chart/chart_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

#include "core/files/text/number.h"

namespace cvo::reports {
namespace {

double OnScale(double value, AxisScale scale) {
  if (scale != AxisScale::kLog) return value;
  return value > 0.0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

const Axis& AxisOf(const Panel& panel, bool x) { return x ? panel.x : panel.y; }

// The coordinates of everything that must be in view.
std::vector<double> ValuesOf(const Panel& panel, bool x) {
  std::vector<double> values;
  for (const Series& series : panel.series) {
    for (const Datum& datum : series.data) {
      if (x || series.kind != SeriesKind::kBand) values.push_back(x ? datum.x : datum.y);
      if (x || !datum.y_interval) continue;
      values.insert(values.end(), {datum.y_interval->low, datum.y_interval->high});
    }
  }
  if (x && panel.rule) values.push_back(*panel.rule);
  return values;
}

ValueRange WithMargins(ValueRange data, const Axis& axis) {
  if (axis.scale == AxisScale::kCategory) {
    return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  }
  if (data.low > data.high) data = {0.0, 1.0};
  double margin = 0.04 * (data.high - data.low);
  if (data.low == data.high) margin = data.low == 0.0 ? 1.0 : 0.1 * std::abs(data.low);
  ValueRange range{data.low - margin, data.high + margin};
  if (axis.from_zero && data.low >= 0.0 && axis.scale == AxisScale::kLinear) range.low = 0.0;
  if (axis.low) range.low = OnScale(*axis.low, axis.scale);
  if (axis.high) range.high = OnScale(*axis.high, axis.scale);
  return range;
}

double NiceStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (least <= times * power * (1.0 + 1e-9)) return times * power;
  }
  return 10.0 * power;
}

// About `most` ticks, more if that makes fewer than three.
std::vector<Tick> LinearTicks(const ValueRange& range, int most, bool integers) {
  double step = NiceStep((range.high - range.low) / most);
  if (integers) step = std::max(step, 1.0);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> ticks;
  for (double k = std::ceil(range.low / step - 1e-6); k * step <= range.high + 1e-6 * step; ++k) {
    const double value = k == 0.0 ? 0.0 : k * step;
    const bool plain = decimals <= 6 && std::abs(value) < 1e7;
    ticks.push_back({value, plain ? FormatFixed(value, decimals) : FormatGeneral(value, 5)});
  }
  return ticks.size() < 3 && most < 8 ? LinearTicks(range, 2 * most, integers) : ticks;
}

// Powers of ten; with 2 and 5 times them if there are few, and if `most` would make fewer than two.
std::vector<Tick> LogTicks(const ValueRange& range, int most) {
  const double decades = range.high - range.low;
  const double every = std::max(1.0, std::ceil(decades / most));
  std::vector<Tick> ticks;
  for (double k = std::floor(range.low); k <= range.high; k += every) {
    for (const double times : {1.0, 2.0, 5.0}) {
      if (times > 1.0 && 3.0 * decades > most) continue;
      const double value = times * std::pow(10.0, k);
      const double at = std::log10(value);
      if (at < range.low - 1e-9 || at > range.high + 1e-9) continue;
      ticks.push_back({value, FormatGeneral(value, 5)});
    }
  }
  return ticks.size() < 2 && decades < 2.0 && most < 6 ? LogTicks(range, 6) : ticks;
}

// The range of the x or y axis of each panel. Panels that share an axis have equal titles of it.
std::vector<ValueRange> RangesOf(const Chart& chart, bool x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<ValueRange> ranges;
  for (const Panel& panel : chart.panels) {
    const Axis& axis = AxisOf(panel, x);
    ValueRange range{kInfinity, -kInfinity};
    for (const Panel& other : chart.panels) {
      const bool shared =
          (x ? chart.share_x : chart.share_y) && AxisOf(other, x).title == axis.title;
      if (!shared && &other != &panel) continue;
      for (const double value : ValuesOf(other, x)) {
        const double at = OnScale(value, axis.scale);
        if (!std::isfinite(at)) continue;
        range = {std::min(range.low, at), std::max(range.high, at)};
      }
    }
    ranges.push_back(WithMargins(range, axis));
  }
  return ranges;
}

// At most about `most` ticks, at integers only if all data are integers.
std::vector<Tick> TicksOf(const Panel& panel, bool x, const ValueRange& range, int most) {
  const Axis& axis = AxisOf(panel, x);
  std::vector<Tick> ticks;
  for (const double value : axis.ticks) ticks.push_back({value, FormatGeneral(value, 3)});
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    ticks.push_back({static_cast<double>(i), axis.categories[i]});
  }
  if (!ticks.empty() || !(range.high > range.low)) return ticks;
  if (axis.scale == AxisScale::kLog) return LogTicks(range, most);
  const std::vector<double> values = ValuesOf(panel, x);
  const bool integers = std::ranges::none_of(
      values, [](double value) { return std::isfinite(value) && value != std::floor(value); });
  return LinearTicks(range, most, integers);
}

// Of a panel of this width, before its scales are made equal.
double HeightOf(const Panel& panel, double width, double em) {
  constexpr double kRow = 1.7;     // of a category on y (em)
  constexpr double kLowest = 7.0;  // em
  return panel.y.scale == AxisScale::kCategory
             ? static_cast<double>(panel.y.categories.size()) * kRow * em
             : std::max(panel.aspect * width, kLowest * em);
}

int TicksAlong(double length, double each) {
  return static_cast<int>(std::clamp(length / each, 2.0, 8.0));
}

// One unit becomes as long on y as on x: one of the ranges grows.
void EqualiseScales(const Panel& panel, Place& place) {
  const double x = place.x.range.high - place.x.range.low;
  const double y = place.y.range.high - place.y.range.low;
  constexpr double kFlattest = 0.3;
  const double aspect = std::clamp(y / x, kFlattest, std::max(kFlattest, panel.aspect));
  place.height = aspect * place.width;
  const auto grow = [](ValueRange& range, double to) {
    const double more = 0.5 * (to - (range.high - range.low));
    range = {range.low - more, range.high + more};
  };
  if (y < aspect * x) grow(place.y.range, aspect * x);
  if (y > aspect * x) grow(place.x.range, y / aspect);
}

}  // namespace

double Scale::Of(double value) const {
  const double part = (OnScale(value, kind) - range.low) / (range.high - range.low);
  return place.low + part * (place.high - place.low);
}

double TextWidth(const std::string& text, double em) {
  double width = 0.0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // within a character of UTF-8
    const bool narrow = std::string_view("ijlItfr.,:;'|!()[]/ ").find(c) != std::string_view::npos;
    const bool wide = std::string_view("mwMWCDGHNOQRU%@").find(c) != std::string_view::npos;
    width += narrow ? 0.36 : wide ? 0.84 : 0.62;
  }
  return width * em;
}

std::vector<std::string> WrapText(const std::string& text, double width, double em) {
  std::istringstream words(text);
  std::vector<std::string> lines;
  for (std::string word; words >> word;) {
    const bool whole = TextWidth(word, em) <= width;
    for (std::size_t begin = 0, end = 0; begin < word.size(); begin = end) {
      end = whole ? word.size() : std::min(word.find('_', begin), word.size() - 1) + 1;
      const std::string piece = word.substr(begin, end - begin);
      const std::string longer =
          lines.empty() ? piece : lines.back() + (begin == 0 ? " " : "") + piece;
      if (!lines.empty() && TextWidth(longer, em) <= width) {
        lines.back() = longer;
      } else {
        lines.push_back(piece);
      }
    }
  }
  return lines;
}

std::vector<Place> PlacePanels(const Chart& chart, std::size_t columns, double width, double em) {
  const std::vector<ValueRange> x_ranges = RangesOf(chart, true);
  const std::vector<ValueRange> y_ranges = RangesOf(chart, false);
  std::vector<Place> places(chart.panels.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Panel& panel = chart.panels[i];
    Place& place = places[i];
    place.x = {panel.x.scale, x_ranges[i], {}, {}};
    place.y = {panel.y.scale, y_ranges[i], {}, {}};
    // Of the panels that share an axis in a column or row, the lowest or first is labelled.
    for (std::size_t k = i + columns; k < places.size() && chart.share_x; k += columns) {
      place.labels_x = place.labels_x && chart.panels[k].x.title != panel.x.title;
    }
    place.labels_y = !chart.share_y || i % columns == 0;
  }
  // Margins hold the lines of titles, which are as long as the panels are high, which depends on
  // what the margins leave.
  std::vector<double> margins;
  double panel_width = width / static_cast<double>(columns) - 5.0 * em;
  for (int pass = 0; pass < 3; ++pass) {
    margins.assign(columns, em);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Panel& panel = chart.panels[i];
      Place& place = places[i];
      if (!place.labels_y) continue;
      const double height = HeightOf(panel, panel_width, em);
      place.widest_y = 0.0;
      for (const Tick& tick : TicksOf(panel, false, y_ranges[i], TicksAlong(height, 2.4 * em))) {
        place.widest_y = std::max(place.widest_y, TextWidth(tick.label, em));
      }
      const auto lines = static_cast<double>(WrapText(panel.y.title, height, em).size());
      double& margin = margins[i % columns];
      margin = std::max(margin, place.widest_y + (0.8 + kLineHeight * lines) * em);
    }
    panel_width = width;
    for (const double margin : margins) panel_width -= margin + em;
    panel_width /= static_cast<double>(columns);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Panel& panel = chart.panels[i];
    Place& place = places[i];
    place.width = panel_width;
    place.left = margins[0];
    for (std::size_t k = 1; k <= i % columns; ++k) place.left += place.width + em + margins[k];
    place.height = HeightOf(panel, panel_width, em);
    if (panel.equal_scale) EqualiseScales(panel, place);
    place.x.ticks = TicksOf(panel, true, place.x.range, TicksAlong(place.width, 5.0 * em));
    place.y.ticks = TicksOf(panel, false, place.y.range, TicksAlong(place.height, 2.4 * em));
    if (panel.y.scale == AxisScale::kCategory) std::swap(place.y.range.low, place.y.range.high);
  }
  return places;
}

}  // namespace cvo::reports
