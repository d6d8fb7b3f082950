// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figure_files/paper_figure.h"

#include <algorithm>
#include <sstream>

#include "reports/figures/numbers.h"
#include "reports/figures/plot.h"

namespace cvo::reports {
namespace {

constexpr int kTitleSize_px = 13;
constexpr int kCaptionSize_px = 11;
constexpr double kLine = 1.32;         // line spacing as a multiple of the font size
constexpr double kLetterWidth = 0.53;  // average letter width as a multiple of the font size
constexpr int kMargin_px = 12;
constexpr char kInk[] = "#222222";
constexpr char kFontFamily[] = "Liberation Sans, Arial, Helvetica, sans-serif";

std::size_t CharactersIn(int width_px, int size_px) {
  return static_cast<std::size_t>((width_px - 2 * kMargin_px) / (kLetterWidth * size_px));
}

int HeightOf(std::size_t lines, int size_px) {
  return static_cast<int>(kLine * size_px * static_cast<double>(lines));
}

// Lines of text as SVG. The baseline of the first one is at `first_px`.
std::string LinesSvg(const std::vector<std::string>& lines, int size_px, int first_px,
                     const char* weight) {
  std::string svg = StrCat("<text font-family=\"", kFontFamily, "\" font-size=\"", size_px,
                           "px\" font-weight=\"", weight, "\" fill=\"", kInk, "\">");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    svg += StrCat("<tspan x=\"", kMargin_px, "\" y=\"", first_px + HeightOf(i, size_px), "\">",
                  PlotText(lines[i]), "</tspan>");
  }
  return svg + "</text>";
}

// The first sentence of a title says what is shown, the rest how it is measured.
struct Title {
  std::vector<std::string> what;
  std::vector<std::string> how;
};

Title MakeTitle(const Figure& figure) {
  const std::size_t characters = CharactersIn(figure.width_px, kTitleSize_px);
  const std::size_t end = figure.title.find(". ");
  Title title{Wrapped(figure.title.substr(0, end), characters * 9 / 10), {}};
  if (end != std::string::npos) {
    title.how =
        Wrapped(figure.title.substr(end + 2), CharactersIn(figure.width_px, kCaptionSize_px));
  }
  return title;
}

}  // namespace

std::vector<std::string> Wrapped(const std::string& text, std::size_t characters) {
  std::istringstream words(text);
  std::vector<std::string> lines;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > characters) {
      lines.push_back(line);
      line.clear();
    }
    line += StrCat(line.empty() ? "" : " ", word);
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

PaperFigure ToPaperFigure(const Figure& figure) {
  Json plotly = ParseJson(figure.plotly, "figure " + figure.id);
  Json& layout = plotly["layout"];
  const Title title = MakeTitle(figure);
  const std::vector<std::string> caption =
      Wrapped(figure.caption, CharactersIn(figure.width_px, kCaptionSize_px));
  const int how_px = kMargin_px + HeightOf(title.what.size(), kTitleSize_px);
  const int above_px = how_px + HeightOf(title.how.size(), kCaptionSize_px) + 6;
  const int below_px = HeightOf(caption.size(), kCaptionSize_px) + kMargin_px;
  const int height_px = layout["height"].get<int>() + above_px + below_px;
  layout["height"] = height_px;
  layout["width"] = figure.width_px;
  layout["autosize"] = false;
  layout["margin"]["t"] = layout["margin"]["t"].get<int>() + above_px;
  layout["margin"]["b"] = layout["margin"]["b"].get<int>() + below_px;
  layout["legend"]["y"] = Rounded(1.0 - static_cast<double>(above_px) / height_px, 6);
  layout["paper_bgcolor"] = "#ffffff";
  layout["plot_bgcolor"] = "#ffffff";
  layout["font"]["color"] = kInk;
  layout["font"]["family"] = kFontFamily;
  PaperFigure paper{PlotJson(plotly["data"], layout), "", figure.title, figure.width_px, height_px};
  paper.texts_svg =
      LinesSvg(title.what, kTitleSize_px, kMargin_px + kTitleSize_px, "bold") +
      LinesSvg(title.how, kCaptionSize_px, how_px + kCaptionSize_px, "normal") +
      LinesSvg(caption, kCaptionSize_px, height_px - below_px + kCaptionSize_px, "normal");
  return paper;
}

std::string FigureJson(const Figure& figure) {
  const Json plotly = ParseJson(figure.plotly, "figure " + figure.id);
  const Json json = {{"id", figure.id},
                     {"group", figure.group},
                     {"title", figure.title},
                     {"caption", figure.caption},
                     {"alt", figure.alt},
                     {"width_px", figure.width_px},
                     {"height_px", figure.height_px},
                     {"data", plotly["data"]},
                     {"layout", plotly["layout"]}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cvo::reports
