// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/chart/chart_layout.h"

namespace cvo::reports {
namespace {

// The grey of the truth, then the colours of Okabe and Ito, which colour-blind people can tell
// apart, and two more.
constexpr std::array kColours = {"#8a8a8a", "#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#a0892c", "#7a5195"};
constexpr std::array kDashes = {"", "5 3", "5 2 1 2", "9 3", "1 2.5"};  // in line widths

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

std::string Stroke(const Look& look, double width) {
  std::string text = StrCat(" class=\"chart-s", look.colour, "\" fill=\"none\" stroke=\"",
                            kColours.at(static_cast<std::size_t>(look.colour)),
                            "\" stroke-width=\"", Num(width), "\"");
  if (look.opacity < 1.0) text += StrCat(" stroke-opacity=\"", Num(look.opacity), "\"");
  if (look.dash > 0) {
    text += StrCat(" stroke-dasharray=\"", kDashes.at(static_cast<std::size_t>(look.dash)), "\"");
  }
  return text;
}

// Symbols of radius 1. The last one is a stroke.
constexpr std::array kSymbols = {"",
                                 "M-1 0a1 1 0 1 0 2 0a1 1 0 1 0-2 0Z",
                                 "M-.9-.9H.9V.9H-.9Z",
                                 "M0-1.3L1.3 0L0 1.3L-1.3 0Z",
                                 "M0-1.2L1.15.85H-1.15Z",
                                 "M-.4-1.2H.4V-.4H1.2V.4H.4V1.2H-.4V.4H-1.2V-.4H-.4Z",
                                 "M0 1.2L1.15-.85H-1.15Z",
                                 "M0-1.15L1.09-.36L.68.93H-.68L-1.09-.36Z",
                                 "M1.15 0L.58 1H-.58L-1.15 0L-.58-1H.58Z",
                                 "M-1.2-1.2L1.2 1.2M-1.2 1.2L1.2-1.2"};

std::string Text(const std::string& text) { return HtmlEscaped(Printable(text)); }

// The end of an element that may have a tooltip.
std::string End(const char* element, const std::string& tip) {
  return tip.empty() ? "/>" : StrCat("><title>", Text(tip), "</title></", element, ">");
}

struct Box {
  double left, top, right, bottom;
};

class SvgWriter {
 public:
  SvgWriter(const Chart& chart, const ChartStyle& style)
      : chart_(chart), style_(style), layout_(LayOut(chart, style)), em_(layout_.em) {}

  std::string Write() {
    constexpr double kMillimetres = 25.4 / 72.0;
    out_ = StrCat("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" role=\"img\"",
                  chart_.title.empty() ? "" : StrCat(" aria-label=\"", Text(chart_.title), "\""),
                  " width=\"", Num(kMillimetres * layout_.width), "mm\" height=\"",
                  Num(kMillimetres * layout_.height), "mm\" viewBox=\"0 0 ", Num(layout_.width),
                  " ", Num(layout_.height), "\" font-family=\"", Text(style_.font),
                  "\" font-size=\"", Num(em_), "\" fill=\"#222222\">\n");
    if (style_.css) out_ += StrCat("<style>", ChartCss(), "</style>\n");
    for (const ChartText& line : layout_.texts) {
      Put(line.x, line.y, line.text, line.bold ? " font-weight=\"bold\"" : "");
    }
    for (const LegendEntry& entry : layout_.legend) Legend(entry);
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
      Draw(chart_.panels[i], layout_.panels[i]);
    }
    return out_ + "</svg>\n";
  }

 private:
  void Put(double x, double y, const std::string& text, const std::string& attributes = "") {
    if (text.empty()) return;
    out_ += StrCat("<text x=\"", Num(x), "\" y=\"", Num(y), "\"", attributes, ">", Text(text),
                   "</text>\n");
  }
  void Line(double x1, double y1, double x2, double y2) {
    out_ += StrCat("<path d=\"M", Num(x1), " ", Num(y1), "L", Num(x2), " ", Num(y2), "\"/>\n");
  }
  void Rect(const Box& box, const std::string& attributes, const std::string& tip = "") {
    out_ += StrCat("<rect x=\"", Num(box.left), "\" y=\"", Num(box.top), "\" width=\"",
                   Num(box.right - box.left), "\" height=\"", Num(box.bottom - box.top), "\"",
                   attributes, End("rect", tip), "\n");
  }
  // A symbol; with no symbol an invisible disc that has the tooltip.
  void Mark(const Look& look, double x, double y, const std::string& tip) {
    const bool open = look.symbol == Symbol::kCross;
    const bool hidden = look.symbol == Symbol::kNone;
    const Look thin{look.colour, look.symbol, 0, 0.4, look.opacity};
    const auto shape = static_cast<std::size_t>(hidden ? Symbol::kCircle : look.symbol);
    out_ += StrCat("<path transform=\"translate(", Num(x), " ", Num(y), ")scale(",
                   Num((hidden ? 0.5 : 0.32) * em_), ")\"",
                   open ? Stroke(thin, thin.width) : Fill(look.colour, hidden ? 0.0 : look.opacity),
                   " d=\"", kSymbols.at(shape), "\"", End("path", tip), "\n");
  }
  void Legend(const LegendEntry& entry) {
    const Look& look = entry.series->look;
    const SeriesKind kind = entry.series->kind;
    const double end = entry.x + kSample * em_;
    if (kind == SeriesKind::kBand) {
      Rect({entry.x, entry.y - 0.4 * em_, end, entry.y + 0.4 * em_},
           Fill(look.colour, look.opacity));
    } else if (kind == SeriesKind::kLine) {
      out_ += StrCat("<g", Stroke(look, look.width), ">\n");
      Line(entry.x, entry.y, end, entry.y);
      out_ += "</g>\n";
    }
    if (look.symbol != Symbol::kNone) Mark(look, 0.5 * (entry.x + end), entry.y, "");
    Put(end + 0.5 * em_, entry.y + 0.35 * em_, entry.series->name);
  }

  void Draw(const Panel& panel, const PanelPlace& place) {
    panel_ = {place.left, place.top, place.left + place.width, place.top + place.height};
    Background(panel, place);
    texts_.clear();
    for (const Series& series : panel.series) DrawSeries(series, place);
    for (const Series& series : panel.series) {
      for (const Datum& datum : series.data) {
        if (datum.text.empty() || !Holds(datum, place)) continue;
        PlaceText(datum, place);
      }
    }
    Axes(panel, place);
  }

  void Background(const Panel& panel, const PanelPlace& place) {
    for (const Shade& shade : panel.shades) {
      Rect({place.x.Of(shade.low), panel_.top, place.x.Of(shade.high), panel_.bottom},
           " class=\"chart-shade\" fill=\"#dddddd\" fill-opacity=\"0.6\"");
    }
    out_ += "<g class=\"chart-grid\" fill=\"none\" stroke=\"#dddddd\" stroke-width=\"0.5\">\n";
    for (const Tick& tick : place.x.ticks) {
      const double x = place.x.Of(tick.value);
      Line(x, panel_.top, x, panel_.bottom);
    }
    for (const Tick& tick : place.y.ticks) {
      const double y = place.y.Of(tick.value);
      if (place.y.kind != AxisScale::kCategory) Line(panel_.left, y, panel_.right, y);
    }
    out_ += "</g>\n";
    for (const Rule& rule : panel.rules) {
      const double at = rule.vertical ? place.x.Of(rule.at) : place.y.Of(rule.at);
      out_ += StrCat("<g", Stroke({0, Symbol::kNone, 4}, 1.0), ">\n");
      if (rule.vertical) Line(at, panel_.top, at, panel_.bottom);
      if (!rule.vertical) Line(panel_.left, at, panel_.right, at);
      out_ += "</g>\n";
      if (!rule.text.empty()) {
        // Above the line, or as near to it as fits.
        const double half = 0.5 * TextWidth(rule.text, em_);
        const double x = rule.vertical ? std::min(at, panel_.right - half) : panel_.right - half;
        Put(x, (rule.vertical ? panel_.top : at) - 0.4 * em_, rule.text, " text-anchor=\"middle\"");
      }
    }
  }

  void Axes(const Panel& panel, const PanelPlace& place) {
    out_ += StrCat("<path class=\"chart-axis\" fill=\"none\" stroke=\"#222222\" d=\"M",
                   Num(panel_.left), " ", Num(panel_.top), "V", Num(panel_.bottom), "H",
                   Num(panel_.right), "\" stroke-width=\"0.7\"/>\n");
    Put(panel_.left, panel_.top - 0.5 * em_, panel.title, " font-weight=\"bold\"");
    if (place.labels_x) AxisX(panel, place);
    if (place.labels_y) AxisY(panel, place);
  }

  void AxisX(const Panel& panel, const PanelPlace& place) {
    double free = -1e9;  // where the label before ends
    for (const Tick& tick : place.x.ticks) {
      const double x = place.x.Of(tick.value);
      const double half = 0.5 * TextWidth(tick.label, em_);
      if (x - half < free) continue;
      free = x + half + 0.5 * em_;
      Put(x, panel_.bottom + 1.2 * em_, tick.label, " text-anchor=\"middle\"");
    }
    Put(0.5 * (panel_.left + panel_.right), panel_.bottom + (kLineHeight + 1.3) * em_,
        panel.x.title, " text-anchor=\"middle\"");
  }

  void AxisY(const Panel& panel, const PanelPlace& place) {
    double widest = 0.0;
    for (const Tick& tick : place.y.ticks) {
      const std::string& text = tick.label;
      widest = std::max(widest, TextWidth(text, em_));
      Put(panel_.left - 0.5 * em_, place.y.Of(tick.value) + 0.35 * em_, text,
          " text-anchor=\"end\"");
    }
    const std::vector<std::string> lines = WrapText(panel.y.title, place.height, em_);
    double x = panel_.left - widest - 1.0 * em_ -
               kLineHeight * em_ * (static_cast<double>(lines.size()) - 1.0);
    for (const std::string& text : lines) {
      const double y = 0.5 * (panel_.top + panel_.bottom);
      Put(x, y, text,
          StrCat(" text-anchor=\"middle\" transform=\"rotate(-90 ", Num(x), " ", Num(y), ")\""));
      x += kLineHeight * em_;
    }
  }

  bool Holds(const Datum& datum, const PanelPlace& place) const {
    constexpr double kRounding = 0.01;
    const auto within = [](double at, double low, double high) {
      return at >= low - kRounding && at <= high + kRounding;
    };
    return within(place.x.Of(datum.x), panel_.left, panel_.right) &&
           within(place.y.Of(datum.y), panel_.top, panel_.bottom);
  }

  void DrawSeries(const Series& series, const PanelPlace& place) {
    const std::string& tip = series.tip.empty() ? series.name : series.tip;
    out_ += tip.empty() ? "<g>\n" : StrCat("<g><title>", Text(tip), "</title>\n");
    if (series.kind == SeriesKind::kLine || series.kind == SeriesKind::kBand) {
      // The inner element cuts what leaves the panel.
      const std::string corner = StrCat(Num(panel_.left), " ", Num(panel_.top));
      const std::string size = StrCat(Num(place.width), " ", Num(place.height));
      const bool line = series.kind == SeriesKind::kLine;
      out_ += StrCat("<svg x=\"", Num(panel_.left), "\" y=\"", Num(panel_.top), "\" width=\"",
                     Num(place.width), "\" height=\"", Num(place.height), "\" viewBox=\"", corner,
                     " ", size, "\"><path stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                     line ? Stroke(series.look, series.look.width)
                          : Fill(series.look.colour, series.look.opacity),
                     " d=\"", line ? PathOf(series, place) : AreaOf(series, place), "\"/></svg>\n");
    }
    for (const Datum& datum : series.data) {
      if (series.kind == SeriesKind::kBand || !Holds(datum, place)) continue;
      const bool shown = series.look.symbol != Symbol::kNone || !datum.tip.empty();
      if (shown) {
        const double x = place.x.Of(datum.x);
        const double y = place.y.Of(datum.y);
        Mark(series.look, x, y, datum.tip);
        texts_.push_back({x - 0.3 * em_, y - 0.3 * em_, x + 0.3 * em_, y + 0.3 * em_});
      }
    }
    out_ += "</g>\n";
  }

  // Points so near to the one before that nobody sees them are left out.
  std::string PathOf(const Series& series, const PanelPlace& place) const {
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

  static std::string AreaOf(const Series& series, const PanelPlace& place) {
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
  void PlaceText(const Datum& datum, const PanelPlace& place) {
    const double size = 0.9 * em_;
    const double width = TextWidth(datum.text, size);
    for (int side = 0; side < 4; ++side) {
      const bool left = side >= 2;
      const bool below = datum.text_below != (side % 2 == 1);
      const double x = place.x.Of(datum.x) + (left ? -0.5 : 0.5) * em_;
      const double y = place.y.Of(datum.y) + (below ? 1.1 : -0.4) * em_;
      const Box box{left ? x - width : x, y - 0.8 * size, left ? x : x + width, y + 0.1 * size};
      const bool inside = box.left >= panel_.left && box.right <= panel_.right + 0.5 * em_ &&
                          box.top >= panel_.top - em_ && box.bottom <= panel_.bottom;
      const bool free = std::none_of(texts_.begin(), texts_.end(), [&](const Box& other) {
        return box.left < other.right && other.left < box.right && box.top < other.bottom &&
               other.top < box.bottom;
      });
      if (!inside || !free) continue;
      texts_.push_back(box);
      Put(x, y, datum.text,
          StrCat(" font-size=\"", Num(size), "\"", left ? " text-anchor=\"end\"" : ""));
      return;
    }
  }

  const Chart& chart_;
  const ChartStyle& style_;
  ChartLayout layout_;
  double em_;
  std::string out_;
  Box panel_{};             // of the panel being drawn
  std::vector<Box> texts_;  // texts and marks in it
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
