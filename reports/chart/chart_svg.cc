// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/chart/chart_axes.h"

namespace cvo::reports {
namespace {

constexpr double kPointsPerMillimetre = 72.0 / 25.4;
constexpr double kSample = 2.0;  // length of a line in the legend (em)

// The grey of the truth, then the colours of Okabe and Ito, which colour-blind people can tell
// apart, and two more.
constexpr std::array kColours = {"#8a8a8a", "#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#a0892c", "#7a5195"};
constexpr std::array kDashes = {"", "5 3", "5 2 1 2", "9 3", "1 2.5"};  // in line widths
// Symbols of radius 1.
constexpr std::array kSymbols = {"", "M-1 0a1 1 0 1 0 2 0a1 1 0 1 0-2 0Z", "M-.9-.9H.9V.9H-.9Z",
                                 "M0-1.3L1.3 0L0 1.3L-1.3 0Z", "M0-1.2L1.15.85H-1.15Z"};

// A number with two decimals at most.
std::string Num(double value) {
  std::string text = FormatFixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

// Attributes that colour a fill or a stroke: a value for programs that know no CSS variables, and a
// class.
std::string Fill(int colour, double opacity) {
  return StrCat(" class=\"chart-f", colour, "\" fill=\"",
                kColours.at(static_cast<std::size_t>(colour)), "\"",
                opacity < 1.0 ? StrCat(" fill-opacity=\"", Num(opacity), "\"") : "");
}

std::string Stroke(const Look& look) {
  std::string text = StrCat(" class=\"chart-s", look.colour, "\" fill=\"none\" stroke=\"",
                            kColours.at(static_cast<std::size_t>(look.colour)),
                            "\" stroke-width=\"", Num(look.width), "\"");
  if (look.dash > 0) {
    text += StrCat(" stroke-dasharray=\"", kDashes.at(static_cast<std::size_t>(look.dash)), "\"");
  }
  return text;
}

std::string Text(const std::string& text) { return HtmlEscaped(Printable(text)); }

class SvgWriter {
 public:
  SvgWriter(const Chart& chart, const ChartStyle& style)
      : chart_(chart),
        style_(style),
        em_(style.font_size_pt),
        width_(chart.width * style.width_mm * kPointsPerMillimetre) {
    // As many columns as leave room for labels and numbers.
    constexpr double kNarrowest = 14.0;  // em
    columns_ = static_cast<std::size_t>(
        std::clamp(static_cast<int>(width_ / (kNarrowest * em_)), 1, chart.columns));
  }

  std::string Write() {
    if (!chart_.title.empty()) {
      // The first sentence says what is shown, the rest how it is measured.
      const std::size_t end = std::min(chart_.title.find(". "), chart_.title.size());
      Lines(chart_.title.substr(0, end), 0.9, " font-weight=\"bold\"");
      if (end < chart_.title.size()) Lines(chart_.title.substr(end + 2), 1.0);
      y_ += 0.5 * em_;
    }
    Legend();
    places_ = PlacePanels(chart_, columns_, width_, em_);
    for (std::size_t i = 0; i < places_.size(); i += columns_) DrawRow(i);
    Lines(chart_.caption, 1.0);
    const double height = y_ + 0.4 * em_;
    return StrCat("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" role=\"img\"",
                  chart_.title.empty() ? "" : StrCat(" aria-label=\"", Text(chart_.title), "\""),
                  " width=\"", Num(width_ / kPointsPerMillimetre), "mm\" height=\"",
                  Num(height / kPointsPerMillimetre), "mm\" viewBox=\"0 0 ", Num(width_), " ",
                  Num(height), "\" font-family=\"", Text(style_.font), "\" font-size=\"", Num(em_),
                  "\" fill=\"#222222\">\n",
                  style_.css ? StrCat("<style>", ChartCss(), "</style>\n") : "", out_, "</svg>\n");
  }

 private:
  void Put(double x, double y, const std::string& text, const std::string& attributes = "") {
    if (text.empty()) return;
    out_ += StrCat("<text x=\"", Num(x), "\" y=\"", Num(y), "\"", attributes, ">", Text(text),
                   "</text>\n");
  }
  void Lines(const std::string& text, double part, const std::string& attributes = "") {
    for (const std::string& line : WrapText(text, part * width_, em_)) {
      y_ += kLineHeight * em_;
      Put(0.0, y_ - 0.3 * em_, line, attributes);
    }
  }
  void Line(double x1, double y1, double x2, double y2) {
    out_ += StrCat("<path d=\"M", Num(x1), " ", Num(y1), "L", Num(x2), " ", Num(y2), "\"/>\n");
  }
  void Rect(const Box& box, const std::string& attributes) {
    out_ += StrCat("<rect x=\"", Num(box.left), "\" y=\"", Num(box.top), "\" width=\"",
                   Num(box.right - box.left), "\" height=\"", Num(box.bottom - box.top), "\"",
                   attributes, "/>\n");
  }
  // A symbol; with no symbol an invisible disc that has the tooltip.
  void Mark(const Look& look, double x, double y, const std::string& tip) {
    const bool hidden = look.symbol == Symbol::kNone;
    const auto shape = static_cast<std::size_t>(hidden ? Symbol::kCircle : look.symbol);
    out_ +=
        StrCat("<path transform=\"translate(", Num(x), " ", Num(y), ")scale(",
               Num((hidden ? 0.5 : 0.32) * em_), ")\"",
               Fill(look.colour, hidden ? 0.0 : look.opacity), " d=\"", kSymbols.at(shape), "\"",
               tip.empty() ? "/>" : StrCat("><title>", Text(tip), "</title></path>"), "\n");
  }

  void Legend() {
    std::vector<std::string> names;
    double x = 0.0;
    for (const Panel& panel : chart_.panels) {
      for (const Series& series : panel.series) {
        if (series.name.empty() || FindBy(names, std::identity(), series.name)) continue;
        names.push_back(series.name);
        const double width = TextWidth(series.name, em_) + (kSample + 2.0) * em_;
        if (x > 0.0 && x + width > width_ + 1.5 * em_) {
          x = 0.0;
          y_ += 1.4 * em_;
        }
        LegendEntry(series, x, y_ + 0.7 * em_);
        x += width;
      }
    }
    if (!names.empty()) y_ += 2.0 * em_;
  }
  void LegendEntry(const Series& series, double x, double y) {
    const Look& look = series.look;
    const double end = x + kSample * em_;
    if (series.kind == SeriesKind::kLine) {
      out_ += StrCat("<g", Stroke(look), ">\n");
      Line(x, y, end, y);
      out_ += "</g>\n";
    }
    if (look.symbol != Symbol::kNone) Mark(look, 0.5 * (x + end), y, "");
    Put(end + 0.5 * em_, y + 0.35 * em_, series.name);
  }

  void DrawRow(std::size_t first) {
    const std::size_t end = std::min(first + columns_, places_.size());
    double above = 0.6;  // em
    double below = 1.0;
    double height = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const Panel& panel = chart_.panels[i];
      const Place& place = places_[i];
      height = std::max(height, place.height);
      const auto lines = [&](const std::string& text) {
        return kLineHeight * static_cast<double>(WrapText(text, place.width, em_).size());
      };
      above = std::max(above, lines(panel.title) + 0.4);
      if (!panel.rule_text.empty()) above = std::max(above, kLineHeight + 0.4);
      if (place.labels_x) below = std::max(below, kLineHeight + 0.9 + lines(panel.x.title));
    }
    for (std::size_t i = first; i < end; ++i) {
      Place& place = places_[i];
      const double top = y_ + above * em_;
      place.box = {place.left, top, place.left + place.width, top + place.height};
      place.x.place = {place.box.left, place.box.right};
      place.y.place = {place.box.bottom, place.box.top};
      Draw(chart_.panels[i], place);
    }
    y_ += (above + below) * em_ + height;
  }

  void Draw(const Panel& panel, const Place& place) {
    Background(panel, place);
    covered_.clear();
    for (const Series& series : panel.series) DrawSeries(series, place);
    for (const Series& series : panel.series) {
      for (const Datum& datum : series.data) {
        if (!datum.text.empty() && Holds(datum, place)) PlaceText(datum, place);
      }
    }
    Axes(panel, place);
  }

  void Background(const Panel& panel, const Place& place) {
    const Box& box = place.box;
    for (const Shade& shade : panel.shades) {
      Rect({place.x.Of(shade.low), box.top, place.x.Of(shade.high), box.bottom},
           " class=\"chart-shade\" fill=\"#dddddd\" fill-opacity=\"0.6\"");
    }
    out_ += "<g class=\"chart-grid\" fill=\"none\" stroke=\"#dddddd\" stroke-width=\"0.5\">\n";
    for (const Tick& tick : place.x.ticks) {
      Line(place.x.Of(tick.value), box.top, place.x.Of(tick.value), box.bottom);
    }
    for (const Tick& tick : place.y.ticks) {
      const double y = place.y.Of(tick.value);
      if (place.y.kind != AxisScale::kCategory) Line(box.left, y, box.right, y);
    }
    out_ += "</g>\n";
    if (!panel.rule) return;
    const double at = place.x.Of(*panel.rule);
    out_ += StrCat("<g", Stroke({0, Symbol::kNone, 4}), ">\n");
    Line(at, box.top, at, box.bottom);
    out_ += "</g>\n";
    Put(std::min(at, box.right - 0.5 * TextWidth(panel.rule_text, em_)), box.top - 0.4 * em_,
        panel.rule_text, " text-anchor=\"middle\"");
  }

  void Axes(const Panel& panel, const Place& place) {
    const Box& box = place.box;
    out_ += StrCat("<path class=\"chart-axis\" fill=\"none\" stroke=\"#222222\" d=\"M",
                   Num(box.left), " ", Num(box.top), "V", Num(box.bottom), "H", Num(box.right),
                   "\" stroke-width=\"0.7\"/>\n");
    const std::vector<std::string> title = WrapText(panel.title, place.width, em_);
    double y = box.top - 0.5 * em_ - kLineHeight * em_ * static_cast<double>(title.size());
    for (const std::string& line : title) {
      Put(box.left, y += kLineHeight * em_, line, " font-weight=\"bold\"");
    }
    if (place.labels_x) AxisX(panel, place);
    if (place.labels_y) AxisY(panel, place);
  }

  void AxisX(const Panel& panel, const Place& place) {
    double free = -1e9;  // where the label before ends
    for (const Tick& tick : place.x.ticks) {
      const double half = 0.5 * TextWidth(tick.label, em_);
      const double x = std::min(place.x.Of(tick.value), width_ - half);
      if (x - half < free) continue;
      free = x + half + 0.5 * em_;
      Put(x, place.box.bottom + 1.2 * em_, tick.label, " text-anchor=\"middle\"");
    }
    double y = place.box.bottom + 1.3 * em_;
    for (const std::string& line : WrapText(panel.x.title, place.width, em_)) {
      Put(0.5 * (place.box.left + place.box.right), y += kLineHeight * em_, line,
          " text-anchor=\"middle\"");
    }
  }

  void AxisY(const Panel& panel, const Place& place) {
    for (const Tick& tick : place.y.ticks) {
      Put(place.box.left - 0.5 * em_, place.y.Of(tick.value) + 0.35 * em_, tick.label,
          " text-anchor=\"end\"");
    }
    const std::vector<std::string> lines = WrapText(panel.y.title, place.height, em_);
    double x = place.box.left - place.widest_y - em_ -
               kLineHeight * em_ * (static_cast<double>(lines.size()) - 1.0);
    for (const std::string& text : lines) {
      const double y = 0.5 * (place.box.top + place.box.bottom);
      Put(x, y, text,
          StrCat(" text-anchor=\"middle\" transform=\"rotate(-90 ", Num(x), " ", Num(y), ")\""));
      x += kLineHeight * em_;
    }
  }

  static bool Holds(const Datum& datum, const Place& place) {
    constexpr double kRounding = 0.01;
    const auto within = [](double at, double low, double high) {
      return at >= low - kRounding && at <= high + kRounding;
    };
    return within(place.x.Of(datum.x), place.box.left, place.box.right) &&
           within(place.y.Of(datum.y), place.box.top, place.box.bottom);
  }

  void DrawSeries(const Series& series, const Place& place) {
    const std::string& tip = series.tip.empty() ? series.name : series.tip;
    out_ += tip.empty() ? "<g>\n" : StrCat("<g><title>", Text(tip), "</title>\n");
    if (series.kind != SeriesKind::kPoints) {
      // The inner element cuts what leaves the panel.
      const bool line = series.kind == SeriesKind::kLine;
      const std::string left = Num(place.box.left);
      const std::string top = Num(place.box.top);
      const std::string width = Num(place.width);
      const std::string height = Num(place.height);
      out_ += StrCat("<svg x=\"", left, "\" y=\"", top, "\" width=\"", width, "\" height=\"",
                     height, "\" viewBox=\"", left, " ", top, " ", width, " ", height,
                     "\"><path stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                     line ? Stroke(series.look) : Fill(series.look.colour, series.look.opacity),
                     " d=\"", line ? PathOf(series, place) : AreaOf(series, place), "\"/></svg>\n");
    }
    for (const Datum& datum : series.data) {
      const bool shown = series.look.symbol != Symbol::kNone || !datum.tip.empty();
      if (series.kind == SeriesKind::kBand || !shown || !Holds(datum, place)) continue;
      const double x = place.x.Of(datum.x);
      const double y = place.y.Of(datum.y);
      Mark(series.look, x, y, datum.tip);
      covered_.push_back({x - 0.3 * em_, y - 0.3 * em_, x + 0.3 * em_, y + 0.3 * em_});
    }
    out_ += "</g>\n";
  }

  // Points so near to the one before that nobody sees them are left out.
  static std::string PathOf(const Series& series, const Place& place) {
    constexpr double kNear = 0.15;
    std::string path;
    double last[] = {0.0, 0.0};
    bool begins = true;
    for (std::size_t i = 0; i < series.data.size(); ++i) {
      const double x = place.x.Of(series.data[i].x);
      const double y = place.y.Of(series.data[i].y);
      const bool ends = i + 1 == series.data.size() || !std::isfinite(series.data[i + 1].x);
      const bool gap = !std::isfinite(x) || !std::isfinite(y);
      const bool near = !begins && std::abs(x - last[0]) + std::abs(y - last[1]) < kNear;
      if (!gap && (!near || ends)) {
        if (begins) path += StrCat("M", Num(x), " ", Num(y));
        path += StrCat("L", Num(x), " ", Num(y));
        last[0] = x;
        last[1] = y;
      }
      begins = gap;
    }
    return path;
  }

  static std::string AreaOf(const Series& series, const Place& place) {
    std::string path;
    std::string back;
    for (const Datum& datum : series.data) {
      if (!datum.y_interval) continue;
      const std::string x = Num(place.x.Of(datum.x));
      path += StrCat(path.empty() ? "M" : "L", x, " ", Num(place.y.Of(datum.y_interval->high)));
      back = StrCat("L", x, " ", Num(place.y.Of(datum.y_interval->low)), back);
    }
    return path.empty() ? "" : path + back + "Z";
  }

  // Writes a text beside its place, where it covers no mark and no other text; nothing if there is
  // no such side.
  void PlaceText(const Datum& datum, const Place& place) {
    const double size = 0.9 * em_;
    const double width = TextWidth(datum.text, size);
    for (int side = 0; side < 4; ++side) {
      const bool left = side >= 2;
      const bool below = datum.text_below != (side % 2 == 1);
      const double x = place.x.Of(datum.x) + (left ? -0.5 : 0.5) * em_;
      const double y = place.y.Of(datum.y) + (below ? 1.1 : -0.4) * em_;
      const Box box{left ? x - width : x, y - 0.8 * size, left ? x : x + width, y + 0.1 * size};
      const bool inside = box.left >= place.box.left && box.right <= place.box.right + 0.5 * em_ &&
                          box.top >= place.box.top - em_ && box.bottom <= place.box.bottom;
      const bool free = std::ranges::none_of(covered_, [&](const Box& other) {
        return box.left < other.right && other.left < box.right && box.top < other.bottom &&
               other.top < box.bottom;
      });
      if (!inside || !free) continue;
      covered_.push_back(box);
      Put(x, y, datum.text,
          StrCat(" font-size=\"", Num(size), "\"", left ? " text-anchor=\"end\"" : ""));
      return;
    }
  }

  const Chart& chart_;
  const ChartStyle& style_;
  double em_;
  double width_;
  std::size_t columns_ = 1;
  double y_ = 0.0;  // the end of what is drawn
  std::string out_;
  std::vector<Place> places_;  // in the order of the chart
  std::vector<Box> covered_;   // texts and marks in the panel that is being drawn
};

}  // namespace

std::string ChartSvg(const Chart& chart, const ChartStyle& style) {
  return SvgWriter(chart, style).Write();
}

std::string ChartCss() {
  std::string css =
      "svg.chart{fill:var(--chart-ink,#222222);background:var(--chart-paper,#ffffff)}"
      ".chart-axis{stroke:var(--chart-ink,#222222)}.chart-grid{stroke:var(--chart-grid,#dddddd)}"
      ".chart-shade{fill:var(--chart-grid,#dddddd)}";
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    const std::string value =
        StrCat("var(--chart-", i == 0 ? "truth" : StrCat(i), ",", kColours[i], ")}");
    css += StrCat(".chart-s", i, "{stroke:", value, ".chart-f", i, "{fill:", value);
  }
  return css;
}

}  // namespace cvo::reports
