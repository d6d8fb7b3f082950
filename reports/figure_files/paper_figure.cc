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
constexpr double kLine = 1.32;         // of the size of its letters, from line to line
constexpr double kLetterWidth = 0.50;  // of its size, on average
constexpr int kMargin_px = 12;
constexpr char kFontFamily[] = "Liberation Sans, Arial, Helvetica, sans-serif";

std::size_t CharactersIn(int width_px, int size_px) {
  return static_cast<std::size_t>((width_px - 2 * kMargin_px) / (kLetterWidth * size_px));
}

int HeightOf(std::size_t lines, int size_px) {
  return static_cast<int>(kLine * size_px * static_cast<double>(lines));
}

// Lines as Plotly draws them. The first sentence is what it is, the rest how it is measured.
std::vector<std::string> TitleLines(const Figure& figure) {
  const std::size_t characters = CharactersIn(figure.width_px, kTitleSize_px);
  const std::size_t end = figure.title.find(". ");
  std::vector<std::string> lines;
  for (const std::string& line : Wrapped(figure.title.substr(0, end), characters * 9 / 10)) {
    lines.push_back(StrCat("<b>", PlotText(line), "</b>"));
  }
  if (end == std::string::npos) return lines;
  for (const std::string& line : Wrapped(figure.title.substr(end + 2), characters)) {
    lines.push_back(PlotText(line));
  }
  return lines;
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += StrCat(text.empty() ? "" : "<br>", line);
  return text;
}

// Lines of SVG, the first one's letters on the height given.
std::string CaptionSvg(const std::vector<std::string>& lines, int first_px) {
  std::string svg = StrCat("<text font-family=\"", kFontFamily, "\" font-size=\"", kCaptionSize_px,
                           "px\" fill=\"#222222\">");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    svg += StrCat("<tspan x=\"", kMargin_px, "\" y=\"", first_px + HeightOf(i, kCaptionSize_px),
                  "\">", PlotText(lines[i]), "</tspan>");
  }
  return svg + "</text>";
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

PaperFigure OnPaper(const Figure& figure) {
  Json plotly = ParseJson(figure.plotly, "figure " + figure.id);
  Json& layout = plotly["layout"];
  const std::vector<std::string> title = TitleLines(figure);
  const std::vector<std::string> caption =
      Wrapped(figure.caption, CharactersIn(figure.width_px, kCaptionSize_px));
  const int above_px = HeightOf(title.size(), kTitleSize_px) + kMargin_px + 4;
  const int below_px = HeightOf(caption.size(), kCaptionSize_px) + kMargin_px;
  const int height_px = layout["height"].get<int>() + above_px + below_px;
  layout["height"] = height_px;
  layout["width"] = figure.width_px;
  layout["autosize"] = false;
  layout["margin"]["t"] = layout["margin"]["t"].get<int>() + above_px;
  layout["margin"]["b"] = layout["margin"]["b"].get<int>() + below_px;
  layout["legend"]["y"] = Rounded(1.0 - static_cast<double>(above_px) / height_px, 6);
  layout["title"] = {{"text", Joined(title)},
                     {"font", {{"size", kTitleSize_px}}},
                     {"xref", "container"},
                     {"yref", "container"},
                     {"x", Rounded(static_cast<double>(kMargin_px) / figure.width_px, 6)},
                     {"xanchor", "left"},
                     {"y", Rounded(1.0 - static_cast<double>(kMargin_px) / height_px, 6)},
                     {"yanchor", "top"}};
  layout["paper_bgcolor"] = "#ffffff";
  layout["plot_bgcolor"] = "#ffffff";
  layout["font"]["color"] = "#222222";
  layout["font"]["family"] = kFontFamily;
  return {PlotJson(plotly["data"], layout),
          CaptionSvg(caption, height_px - below_px + kCaptionSize_px), figure.width_px, height_px};
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
