// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "core/files/text/utf8.h"
#include "reports/formats/table_html.h"

namespace cvo::reports {
namespace {

// Greys have a contrast of at least 4.5 to 1 with their background, in light and in dark style.
constexpr char kStyle[] = R"(
:root { color-scheme: light dark; --text: #1b1f24; --page: #ffffff; --line: #d0d7de;
        --quiet: #59636e; --stripe: #f6f8fa; --best: #0a5c2b; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6edf3; --page: #0d1117; --line: #3d444d; --quiet: #9198a1;
          --stripe: #151b23; --best: #6fdd8b; }
}
body { margin: 0 auto; padding: 1rem; max-width: 110rem; color: var(--text);
       background: var(--page); font: 15px/1.45 system-ui, sans-serif; }
.cvo-scroll { overflow-x: auto; margin-bottom: 1.5rem; }
.cvo-scroll:focus-visible { outline: 2px solid currentColor; outline-offset: 2px; }
table { border-collapse: collapse; border-top: 2px solid; border-bottom: 2px solid; }
caption { text-align: left; padding-bottom: .5rem; color: var(--quiet); }
.cvo-caption { display: inline-block; position: sticky; left: 0; max-width: calc(100vw - 3rem); }
.cvo-title { font-weight: 600; font-size: 1.1rem; color: var(--text); }
th, td { padding: .3rem .6rem; text-align: left; vertical-align: top; }
thead th { border-bottom: 1px solid; vertical-align: bottom; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; }
tbody th { font-weight: 600; }
tr.reference th { font-weight: 400; }
tbody th:first-child { position: sticky; left: 0; background: var(--page); }
tbody tr { border-top: 1px solid var(--line); }
tbody tr.ours, tbody tr.ours th:first-child { background: var(--stripe); }
.interval, .percent, .n, .reason { display: block; white-space: nowrap; font-size: .85em; }
.interval, .n, .reason, .unit, .mark, .grey { color: var(--quiet); }
.reason { white-space: normal; min-width: 9em; font-style: italic; }
.best .value, .best .mark { color: var(--best); }
.mark { font-size: .8em; }
.star { display: inline-block; width: 0; text-decoration: none; }
.cvo-notes { color: var(--quiet); max-width: 60rem; font-size: .9rem; }
.cvo-notes ul { padding-left: 1.2rem; }
)";

}  // namespace

std::string HtmlPage(const std::string& page_title, const std::string& body) {
  const std::string title = HtmlEscaped(Printable(page_title));
  return StrCat(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' "
      "file:; style-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
      title.empty() ? "table" : title, "</title>\n<style>", kStyle, "</style>\n</head>\n<body>\n",
      body, "</body>\n</html>\n");
}

}  // namespace cvo::reports
