// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figure_files/render_page.h"

#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/web/assets.h"

namespace cvo::reports {
namespace {

constexpr std::string_view kBegin = "[[figure ";
constexpr std::string_view kFailed = "[[failed ";
constexpr std::string_view kEnd = "]]";

// Plotly gives parts of a drawing random names. A fixed seed makes the output deterministic.
constexpr char kSeeded[] = R"(
let state = 1;
Math.random = () => {
  state = (state * 48271) % 2147483647;
  return state / 2147483647;
};
)";

// Texts are output as base64 of UTF-8, which neither markup nor messages of the browser can
// corrupt. The script itself does not contain the complete marks, so that a page that did not
// finish is not taken for one that did.
constexpr char kDraw[] = R"(
const coded = (text) => {
  let bytes = '';
  for (const byte of new TextEncoder().encode(text)) bytes += String.fromCharCode(byte);
  return btoa(bytes);
};
const draw = async (figure) => {
  const size = {width: figure.layout.width, height: figure.layout.height};
  const url = await Plotly.toImage(figure, {format: 'svg', ...size});
  return decodeURIComponent(url.slice(url.indexOf(',') + 1));
};
const all = async () => {
  const texts = [];
  for (const figure of figures) texts.push('[' + '[figure ' + coded(await draw(figure)) + ']]');
  return texts.join('\n');
};
all().catch((error) => '[' + '[failed ' + coded(String(error)) + ']]').then((text) => {
  document.body.textContent = text;
});
)";

int Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

std::string Decoded(std::string_view base64) {
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64) {
    const int digit = Digit(c);
    if (digit < 0) continue;
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    text += static_cast<char>((bits >> count) & 0xFFU);
  }
  return text;
}

// The decoded text between the first `mark` from `at` on and the end mark. Moves `at` to that end
// mark.
std::optional<std::string> Between(std::string_view page, std::string_view mark, std::size_t& at) {
  const std::size_t begin = page.find(mark, at);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t end = page.find(kEnd, begin);
  if (end == std::string_view::npos) return std::nullopt;
  at = end;
  return Decoded(page.substr(begin + mark.size(), end - begin - mark.size()));
}

std::string WithTexts(std::string svg, const PaperFigure& figure) {
  const std::size_t end = svg.rfind("</svg>");
  if (end == std::string::npos) ThrowError("browser", "a figure that is no SVG", "one");
  return svg.insert(end, figure.texts_svg) + "\n";
}

// Replaces the hexadecimal digits that follow each mark, up to `stop`, by `digits` and then by
// zeros.
void Blank(const std::string& mark, char stop, std::string_view digits, std::string& text) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
    std::size_t used = 0;
    for (std::size_t i = at + mark.size(); i < text.size() && text[i] != stop; ++i) {
      if (std::isxdigit(static_cast<unsigned char>(text[i])) == 0) continue;
      text[i] = used < digits.size() ? digits[used] : '0';
      ++used;
    }
  }
}

}  // namespace

std::string RenderPage(const std::vector<PaperFigure>& figures) {
  std::string page = "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>figures</title>";
  page += StrCat("<script>", kSeeded, "</script>\n<script>", PlotlyScript(),
                 "</script></head>\n<body>");
  page += "<script>\nconst figures = [";
  for (const PaperFigure& figure : figures) page += figure.plotly + ",\n";
  return StrCat(page, "];", kDraw, "</script></body></html>\n");
}

std::vector<std::string> ReadRendered(std::string_view dumped_page,
                                      const std::vector<PaperFigure>& figures) {
  const std::size_t body = dumped_page.rfind("<body");
  std::size_t at = body == std::string_view::npos ? dumped_page.size() : body;
  std::size_t failed_at = at;
  if (const auto message = Between(dumped_page, kFailed, failed_at)) {
    ThrowError("browser", StrCat("\"", *message, "\""), "figures drawn");
  }
  std::vector<std::string> texts;
  while (const auto svg = Between(dumped_page, kBegin, at)) {
    if (texts.size() == figures.size()) break;
    texts.push_back(WithTexts(*svg, figures[texts.size()]));
  }
  if (texts.size() != figures.size()) {
    ThrowError("browser", StrCat(texts.size(), " figures drawn"), StrCat(figures.size()));
  }
  return texts;
}

std::string PrintPage(const std::string& svg, const PaperFigure& figure) {
  return StrCat(
      "<!DOCTYPE html>\n<html><head><meta "
      "charset=\"utf-8\"><title>",
      PlotText(figure.title), "</title><style>@page{size:", figure.width_px, "px ",
      figure.height_px,
      "px;margin:0}html,body{margin:0;padding:0}svg{display:block}</style></head><body>", svg,
      "</body></html>\n");
}

std::string WithoutDates(std::string pdf) {
  constexpr std::string_view kDay = "20000101000000";
  Blank("/CreationDate (D:", ')', kDay, pdf);
  Blank("/ModDate (D:", ')', kDay, pdf);
  Blank("/ID [<", ']', "", pdf);
  return pdf;
}

}  // namespace cvo::reports
