// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/render_figures.h"

#include "experiments/cli/pictures/browser.h"
#include "experiments/cli/scratch_folder.h"
#include "reports/figure_files/render_page.h"

namespace cvo {

std::vector<NamedContent> RenderFigures(const std::vector<reports::Figure>& figures,
                                        const std::string& format) {
  const ScratchFolder scratch;
  const Browser browser(scratch.path());
  std::vector<reports::PaperFigure> papers;
  for (const reports::Figure& figure : figures) papers.push_back(reports::ToPaperFigure(figure));
  const std::vector<std::string> svgs =
      reports::ReadRendered(browser.Run(reports::RenderPage(papers)), papers);
  std::vector<NamedContent> files;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string name = figures[i].id + "." + format;
    files.push_back(format == "pdf"
                        ? NamedContent{name, reports::WithoutDates(browser.Print(
                                                 reports::PrintPage(svgs[i], papers[i])))}
                        : NamedContent{name, svgs[i]});
  }
  return files;
}

}  // namespace cvo
