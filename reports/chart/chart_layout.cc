// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/chart/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

#include "core/base/lists.h"
#include "core/files/text/number.h"

namespace cvo::reports {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPointsPerMillimetre = 72.0 / 25.4;

double OnScale(double value, AxisScale scale) {
  if (scale != AxisScale::kLog) return value;
  return value > 0.0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

void Widen(double value, AxisScale scale, ValueRange& range) {
  const double at = OnScale(value, scale);
  if (!std::isfinite(at)) return;
  range.low = std::min(range.low, at);
  range.high = std::max(range.high, at);
}

void WidenByData(const Panel& panel, bool x, ValueRange& range) {
  const AxisScale scale = x ? panel.x.scale : panel.y.scale;
  for (const Series& series : panel.series) {
    for (const Datum& datum : series.data) {
      if (x || series.kind != SeriesKind::kBand) Widen(x ? datum.x : datum.y, scale, range);
      if (x || !datum.y_interval) continue;
      Widen(datum.y_interval->low, scale, range);
      Widen(datum.y_interval->high, scale, range);
    }
  }
  for (const Rule& rule : panel.rules) {
    if (rule.vertical == x) Widen(rule.at, scale, range);
  }
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

// The range of one axis of each panel. Panels that share an axis have equal titles of it.
std::vector<ValueRange> RangesOf(const Chart& chart, bool x) {
  const auto axis = [x](const Panel& panel) -> const Axis& { return x ? panel.x : panel.y; };
  std::vector<ValueRange> ranges;
  for (const Panel& panel : chart.panels) {
    ValueRange range{kInfinity, -kInfinity};
    for (const Panel& other : chart.panels) {
      const bool shared =
          (x ? chart.share_x : chart.share_y) && axis(other).title == axis(panel).title;
      if (shared || &other == &panel) WidenByData(other, x, range);
    }
    ranges.push_back(WithMargins(range, axis(panel)));
  }
  return ranges;
}

// Whether the x axis of a panel is labelled: of those that share it in a column, the lowest is.
bool HasLabelsX(const Chart& chart, std::size_t panel) {
  const auto columns = static_cast<std::size_t>(chart.columns);
  for (std::size_t i = panel + columns; i < chart.panels.size() && chart.share_x; i += columns) {
    if (chart.panels[i].x.title == chart.panels[panel].x.title) return false;
  }
  return true;
}

double NiceStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (least <= times * power * (1.0 + 1e-9)) return times * power;
  }
  return 10.0 * power;
}

std::vector<Tick> LinearTicks(const ValueRange& range, int most) {
  const double step = NiceStep((range.high - range.low) / most);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> ticks;
  for (double k = std::ceil(range.low / step - 1e-6); k * step <= range.high + 1e-6 * step; ++k) {
    const double value = k == 0.0 ? 0.0 : k * step;
    const bool plain = decimals <= 6 && std::abs(value) < 1e7;
    ticks.push_back({value, plain ? FormatFixed(value, decimals) : FormatGeneral(value, 5)});
  }
  return ticks;
}

// Powers of ten; with 2 and 5 times them if there are few.
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
  return ticks;
}

std::vector<Tick> TicksOf(const Axis& axis, const ValueRange& range, int most) {
  std::vector<Tick> ticks;
  for (const double value : axis.ticks) ticks.push_back({value, FormatGeneral(value, 3)});
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    ticks.push_back({static_cast<double>(i), axis.categories[i]});
  }
  if (!ticks.empty() || !(range.high > range.low)) return ticks;
  return axis.scale == AxisScale::kLog ? LogTicks(range, most) : LinearTicks(range, most);
}

int TicksAlong(double length, double each) {
  return static_cast<int>(std::clamp(length / each, 2.0, 8.0));
}

void AddText(const std::string& text, bool bold, double em, double& y, ChartLayout& layout) {
  for (const std::string& line : WrapText(text, layout.width * (bold ? 0.9 : 1.0), em)) {
    y += kLineHeight * em;
    layout.texts.push_back({0.0, y - 0.3 * em, line, bold});
  }
}

// The first sentence of the title says what is shown, the rest how it is measured.
void AddTitle(const std::string& title, double& y, ChartLayout& layout) {
  if (title.empty()) return;
  const std::size_t end = std::min(title.find(". "), title.size());
  AddText(title.substr(0, end), true, layout.em, y, layout);
  if (end < title.size()) AddText(title.substr(end + 2), false, layout.em, y, layout);
  y += 0.5 * layout.em;
}

void AddLegend(const Chart& chart, double& y, ChartLayout& layout) {
  std::vector<std::string> names;
  double x = 0.0;
  for (const Panel& panel : chart.panels) {
    for (const Series& series : panel.series) {
      if (series.name.empty() || FindBy(names, std::identity(), series.name)) continue;
      names.push_back(series.name);
      const double width = TextWidth(series.name, layout.em) + (kSample + 2.0) * layout.em;
      if (x > 0.0 && x + width > layout.width + 1.5 * layout.em) {
        x = 0.0;
        y += 1.4 * layout.em;
      }
      layout.legend.push_back({x, y + 0.7 * layout.em, &series});
      x += width;
    }
  }
  if (!names.empty()) y += 2.0 * layout.em;
}

// One unit becomes as long on y as on x: one of the ranges grows.
void EqualiseScales(const Panel& panel, PanelPlace& place) {
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

// Everything about a panel but its position.
void Measure(const Panel& panel, double em, PanelPlace& place) {
  constexpr double kRowHeight = 1.7;  // of a category on y, in font sizes
  place.height = panel.y.scale == AxisScale::kCategory
                     ? static_cast<double>(panel.y.categories.size()) * kRowHeight * em
                     : panel.aspect * place.width;
  if (panel.equal_scale) EqualiseScales(panel, place);
  place.x.ticks = TicksOf(panel.x, place.x.range, TicksAlong(place.width, 5.0 * em));
  place.y.ticks = TicksOf(panel.y, place.y.range, TicksAlong(place.height, 2.4 * em));
  if (panel.y.scale == AxisScale::kCategory) std::swap(place.y.range.low, place.y.range.high);
}

// The room for the labels and the title of the y axes of a column of panels.
double LeftMargin(const Chart& chart, std::size_t column, const ChartLayout& layout) {
  const double em = layout.em;
  const auto columns = static_cast<std::size_t>(chart.columns);
  const double usual = layout.width / chart.columns - 5.0 * em;
  double margin = em;
  for (std::size_t i = column; i < chart.panels.size(); i += columns) {
    if (!layout.panels[i].labels_y) continue;
    const Panel& panel = chart.panels[i];
    double widest = 0.0;
    const int ticks = TicksAlong(panel.aspect * usual, 2.4 * em);
    for (const Tick& tick : TicksOf(panel.y, layout.panels[i].y.range, ticks)) {
      widest = std::max(widest, TextWidth(tick.label, em));
    }
    const double lines =
        static_cast<double>(WrapText(panel.y.title, 0.9 * panel.aspect * usual, em).size());
    margin = std::max(margin, widest + (0.8 + kLineHeight * lines) * em);
  }
  return margin;
}

// Sets the left edges and the widths, which are the same for all panels.
void PlaceColumns(const Chart& chart, ChartLayout& layout) {
  const auto columns = static_cast<std::size_t>(chart.columns);
  std::vector<double> margins;
  double all = 0.0;
  for (std::size_t column = 0; column < columns; ++column) {
    margins.push_back(LeftMargin(chart, column, layout));
    all += margins.back() + layout.em;
  }
  const double width = (layout.width - all) / chart.columns;
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    layout.panels[i].width = width;
    layout.panels[i].left = margins[0];
    for (std::size_t k = 1; k <= i % columns; ++k) {
      layout.panels[i].left += width + layout.em + margins[k];
    }
  }
}

void PlaceRow(const Chart& chart, std::size_t first, double& y, ChartLayout& layout) {
  const double em = layout.em;
  const std::size_t end =
      std::min(first + static_cast<std::size_t>(chart.columns), chart.panels.size());
  double above = 0.6 * em;
  double below = 0.6 * em;
  double height = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    PanelPlace& place = layout.panels[i];
    Measure(chart.panels[i], em, place);
    height = std::max(height, place.height);
    double labels = place.labels_x ? kLineHeight * em + 0.5 * em : 0.0;
    if (place.labels_x && !chart.panels[i].x.title.empty()) labels += kLineHeight * em;
    below = std::max(below, labels + 0.4 * em);
    const bool has_rules = std::any_of(chart.panels[i].rules.begin(), chart.panels[i].rules.end(),
                                       [](const Rule& rule) { return !rule.text.empty(); });
    const bool titled = !chart.panels[i].title.empty() || has_rules;
    if (titled) above = 1.7 * em;
  }
  for (std::size_t i = first; i < end; ++i) {
    PanelPlace& place = layout.panels[i];
    place.top = y + above;
    place.x.place = {place.left, place.left + place.width};
    place.y.place = {place.top + place.height, place.top};
  }
  y += above + height + below;
}

bool IsNarrow(char c) {
  return std::string_view("ijlItfr.,:;'|!()[]/ ").find(c) != std::string::npos;
}

bool IsWide(char c) { return std::string_view("mwMWCDGHNOQRU%@").find(c) != std::string::npos; }

}  // namespace

double Scale::Of(double value) const {
  const double part = (OnScale(value, kind) - range.low) / (range.high - range.low);
  return place.low + part * (place.high - place.low);
}

double TextWidth(const std::string& text, double em) {
  double width = 0.0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // within a character of UTF-8
    width += IsNarrow(c) ? 0.36 : IsWide(c) ? 0.84 : 0.62;
  }
  return width * em;
}

std::vector<std::string> WrapText(const std::string& text, double width, double em) {
  std::istringstream words(text);
  std::vector<std::string> lines;
  for (std::string word; words >> word;) {
    if (!lines.empty() && TextWidth(lines.back() + " " + word, em) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

ChartLayout LayOut(const Chart& chart, const ChartStyle& style) {
  ChartLayout layout;
  layout.em = style.font_size_pt;
  layout.width = chart.width * style.width_mm * kPointsPerMillimetre;
  double y = 0.0;
  AddTitle(chart.title, y, layout);
  AddLegend(chart, y, layout);
  const std::vector<ValueRange> x_ranges = RangesOf(chart, true);
  const std::vector<ValueRange> y_ranges = RangesOf(chart, false);
  const auto columns = static_cast<std::size_t>(chart.columns);
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const Panel& panel = chart.panels[i];
    PanelPlace place;
    place.x = {panel.x.scale, x_ranges[i], {}, {}};
    place.y = {panel.y.scale, y_ranges[i], {}, {}};
    place.labels_x = HasLabelsX(chart, i);
    place.labels_y = !chart.share_y || i % columns == 0;
    layout.panels.push_back(std::move(place));
  }
  PlaceColumns(chart, layout);
  for (std::size_t i = 0; i < chart.panels.size(); i += columns) PlaceRow(chart, i, y, layout);
  AddText(chart.caption, false, layout.em, y, layout);
  layout.height = y + 0.4 * layout.em;
  return layout;
}

}  // namespace cvo::reports
