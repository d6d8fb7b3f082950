// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figure_files/paper_figure.h"

#include <gmock/gmock.h>

#include "reports/figure_files/interactive_page.h"
#include "reports/figure_files/render_page.h"
#include "reports/figures/heat_map.h"
#include "tests/reports/figures/drawn_suite.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

Figure SmallFigure() {
  Figure figure = SuiteFigures(test::DrawnSuite({"full"})).figures.at(0);
  figure.title = "What <it> is. How it is measured";
  figure.caption = "Marks & more.";
  return figure;
}

TEST(PaperFigure, WrapsTextsAtWords) {
  EXPECT_THAT(Wrapped("one two  three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(Wrapped("extraordinary a", 5), ElementsAre("extraordinary", "a"));
  EXPECT_THAT(Wrapped("", 5), IsEmpty());
}

TEST(PaperFigure, HasRoomForTitleAndCaption) {
  const Figure figure = SmallFigure();
  const PaperFigure paper = ToPaperFigure(figure);
  const Json before = Json::parse(figure.plotly)["layout"];
  const Json layout = Json::parse(paper.plotly)["layout"];
  EXPECT_EQ(layout["width"], figure.width_px);
  EXPECT_EQ(layout["height"], paper.height_px);
  const int more_px = paper.height_px - figure.height_px;
  EXPECT_GT(more_px, 30);
  EXPECT_EQ(layout["margin"]["t"].get<int>() + layout["margin"]["b"].get<int>(),
            before["margin"]["t"].get<int>() + before["margin"]["b"].get<int>() + more_px)
      << "the part that holds the data keeps its size";
  EXPECT_THAT(paper.texts_svg, AllOf(HasSubstr(">What &lt;it&gt; is</tspan>"),
                                     HasSubstr(">How it is measured</tspan>"),
                                     HasSubstr(">Marks &amp; more.</tspan>")));
  EXPECT_THAT(paper.plotly, Not(HasSubstr("<")));
}

TEST(PaperFigure, JsonHasAllData) {
  const Figure figure = SmallFigure();
  const Json json = Json::parse(FigureJson(figure));
  EXPECT_EQ(json["id"], figure.id);
  EXPECT_EQ(json["alt"], figure.alt);
  EXPECT_EQ(json["caption"], figure.caption);
  EXPECT_EQ(json["layout"], Json::parse(figure.plotly)["layout"]);
  EXPECT_EQ(json["data"], Json::parse(figure.plotly)["data"]);
}

TEST(RenderPage, UsesNoRandomnessAndNoNetwork) {
  const std::string page = RenderPage({ToPaperFigure(SmallFigure())});
  EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("Math.random = ")));
  EXPECT_LT(page.find("Math.random = "), page.find("Plotly"));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
}

TEST(InteractivePage, FollowsTheColourSchemeAndSendsNothing) {
  const std::string page = InteractivePage(SmallFigure());
  EXPECT_THAT(page, AllOf(HasSubstr("prefers-color-scheme: dark"), HasSubstr("width < LEAST"),
                          HasSubstr("showSendToCloud: false"), Not(HasSubstr("<script src"))));
}

TEST(DrawHeatMap, HasRoomForHeadingsAndBar) {
  const auto layout = [](const std::string& heading) {
    const std::vector<HeatBlock> blocks = {{"full", {{"tiny", {HeatCell{-5.0, false, "+5", ""}}}}}};
    Json made = DrawHeatMap(blocks, {{"a", heading}}).layout();
    return made;
  };
  const Json usual = layout("camera<br>ATE");
  const Json tall = layout("a heading that is longer than most<br>of the others");
  EXPECT_GT(tall["margin"]["t"].get<int>(), usual["margin"]["t"].get<int>() + 80);
  const int inner = usual["height"].get<int>() - usual["margin"]["t"].get<int>();
  EXPECT_GE(inner, usual["coloraxis"]["colorbar"]["len"].get<int>());
}

TEST(RenderPage, RenderedFigureIsReadBackWithTitleAndCaption) {
  const std::vector<PaperFigure> papers = {ToPaperFigure(SmallFigure())};
  // base64 of "<svg></svg>"
  const std::string page = "<html><body>[[figure PHN2Zz48L3N2Zz4=]]</body></html>";
  const std::vector<std::string> svgs = ReadRendered(page, papers);
  EXPECT_THAT(svgs, ElementsAre("<svg>" + papers[0].texts_svg + "</svg>\n"));
}

TEST(RenderPage, ReportsFailures) {
  const std::vector<PaperFigure> papers = {ToPaperFigure(SmallFigure())};
  const auto message = [&](const std::string& page) {
    return ErrorMessage([&] { ReadRendered(page, papers); });
  };
  // base64 of "no WebGL"
  EXPECT_THAT(message("<body>[[failed bm8gV2ViR0w=]]</body>"), HasSubstr("\"no WebGL\""));
  EXPECT_THAT(message("<body></body>"), HasSubstr("0 figures drawn"));
  EXPECT_THAT(message(RenderPage(papers)), HasSubstr("0 figures drawn"))
      << "a page that did not run";
  EXPECT_THAT(message(""), HasSubstr("0 figures drawn"));
  EXPECT_THAT(message("<body>[[figure AAAA]]</body>"), HasSubstr("no SVG"));
}

TEST(PrintPage, HasTheSizeOfTheFigure) {
  const PaperFigure paper = ToPaperFigure(SmallFigure());
  EXPECT_THAT(PrintPage("<svg></svg>", paper),
              AllOf(HasSubstr("size:" + std::to_string(paper.width_px) + "px " +
                              std::to_string(paper.height_px) + "px"),
                    HasSubstr("<title>What &lt;it&gt; is. How"), HasSubstr("<svg></svg>")));
}

TEST(Pdf, HasNoTimestamp) {
  const std::string made =
      "x /CreationDate (D:20261122021536+00'00') /ModDate (D:20261122021537+00'00') y";
  const std::string then =
      "x /CreationDate (D:20250101000001+00'00') /ModDate (D:20250101000002+00'00') y";
  EXPECT_EQ(WithoutDates(made), WithoutDates(then));
  EXPECT_EQ(WithoutDates(made).size(), made.size()) << "places in a PDF are counted in bytes";
  EXPECT_THAT(WithoutDates(made), HasSubstr("(D:20000101000000+00'00')"));
  EXPECT_EQ(WithoutDates("/ID [<0AF1> <22>]"), "/ID [<0000> <00>]");
}

}  // namespace
}  // namespace cvo::reports
