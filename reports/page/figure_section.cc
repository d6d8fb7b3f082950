// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"

namespace cvo::reports {
namespace {

std::vector<std::string> Groups(const std::vector<Figure>& figures) {
  std::vector<std::string> groups;
  for (const Figure& figure : figures) AddOnce(figure.group, groups);
  return groups;
}

// Emphasises the first sentence of a title, which says what is shown, over the rest, which says how
// it was measured.
std::string TitleHtml(const std::string& title) {
  const auto end = title.find(". ");
  if (end == std::string::npos) return Element("strong", title);
  return Element("strong", title.substr(0, end + 1)) + " " + Escaped(title.substr(end + 2));
}

std::string FigureHtml(const Figure& figure, std::size_t index) {
  const std::string alt = Escaped(figure.alt);
  const std::string width =
      figure.least_px > 0 ? StrCat(";min-width:", figure.least_px, "px") : std::string();
  return StrCat("<figure class=\"figure\" data-figure=\"figure-", index, "\">\n<figcaption>",
                TitleHtml(figure.title), "<p class=\"reading\">", Escaped(figure.caption),
                "</p></figcaption>\n<div class=\"plot-scroll\"><div class=\"plot\" role=\"img\" "
                "aria-label=\"",
                alt, "\" data-width=\"", figure.width_px,
                "\" style=\"min-height:", figure.height_px, "px", width,
                "\"></div></div>\n<details><summary>In words</summary><p>", alt,
                "</p></details>\n</figure>\n");
}

}  // namespace

std::string FigureSection(const PageContent& content) {
  std::string html = "<section id=\"figures\">\n<h2>Figures</h2>\n";
  if (content.drawing.figures.empty())
    html += "<p class=\"problem\">No figure could be made from these results.</p>\n";
  for (const std::string& group : Groups(content.drawing.figures)) {
    html += Element("h3", group) + "\n<div class=\"figures\">\n";
    for (std::size_t i = 0; i < content.drawing.figures.size(); ++i) {
      if (content.drawing.figures[i].group == group)
        html += FigureHtml(content.drawing.figures[i], i);
    }
    html += "</div>\n";
  }
  return html + "</section>\n";
}

std::string SceneSection(const PageContent& content) {
  std::string html = "<section id=\"scenes\">\n<h2>Frame by frame</h2>\n";
  if (content.scenes.empty()) {
    return html +
           "<p class=\"problem\">No run can be shown: none has trajectories.</p>\n</section>\n";
  }
  html += "<p>Trajectories, clusters, images and errors of one run at a selected time.";
  if (content.scenes_left_out > 0) {
    html += StrCat(" The page holds ", Counted(content.scenes.size(), "run"), "; ",
                   content.scenes_left_out, " more would make it too large.");
  }
  return html +
         "</p>\n<div id=\"scene-view\"><noscript>This view needs "
         "JavaScript.</noscript></div>\n</section>\n";
}

}  // namespace cvo::reports
