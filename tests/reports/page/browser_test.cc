// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Opens the page in Chromium, with its script.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "core/base/error.h"
#include "reports/page/page.h"
#include "tests/reports/results/result_files.h"

namespace cvo::browser_test {
namespace {

namespace fs = std::filesystem;
using reports::PageContent;
using test::SuiteResults;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Browser : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium > /dev/null") != 0) {
      GTEST_SKIP() << "no Chromium (packages.txt) to open the page with";
    }
  }

  // A page with three rows and a run of three images.
  std::string WritePage() const {
    SuiteResults suite;
    suite.name = "<img src=x onerror=\"document.documentElement.dataset.hacked=1\">";
    double error_m = 0.5;
    for (const char* variant : {"2d", "full", "static"}) {
      test::Json result = test::Result("room");
      error_m = error_m == 0.5 ? 0.25 : 2.0 * error_m;  // 0.25, 0.5, 0.25
      result["metrics"][1]["value"] = error_m;
      suite.Add(result, variant);
    }
    reports::PageRequest request;
    request.folder = suite.Written();
    PageContent content = ReadPage(request);
    reports::PageScene scene;
    for (const int frame : {10, 11, 12}) {
      scene.images.push_back({frame, "", StrCat("what frame ", frame, " shows")});
    }
    content.scenes = {scene};
    return folder_.Write("page/index.html", PageHtml(content)).string();
  }

  // The document after the script has run.
  std::string Opened(const std::string& page, const std::string& fragment) const {
    const std::string home = folder_.path().string();
    const std::string command =
        "HOME='" + home + "' timeout 60 chromium --headless --no-sandbox --disable-gpu " +
        "--disable-quic --no-first-run --disable-background-networking " +
        "--disable-component-update --disable-sync --user-data-dir='" + home + "/profile' " +
        "--dump-dom 'file://" + page + fragment + "' 2> /dev/null";
    FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> part{};
    while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) {
      text.append(part.data(), size);
    }
    EXPECT_EQ(::pclose(pipe), 0);
    return text;
  }

  test::TempFolder folder_;
};

// The order of the rows of the table of values.
std::string Order(const std::string& document) {
  const std::string table = document.substr(document.find("id=\"table-values\""));
  std::string order;
  for (auto at = table.find("<th scope=\"row\">room"); at < table.find("</table>");
       at = table.find("<th scope=\"row\">room", at + 1)) {
    const auto begin = table.find("<th scope=\"row\">", at + 1) + 16;
    order += table.substr(begin, table.find('<', begin) - begin) + " ";
  }
  return order;
}

TEST_F(Browser, SortsAndMovesThroughFrames) {
  const std::string page = WritePage();
  const std::string plain = Opened(page, "");
  EXPECT_THAT(plain, AllOf(HasSubstr("data-ready=\"true\""), Not(HasSubstr("data-hacked")),
                           ContainsRegex("<p id=\"script-problem\"[^>]*hidden=\"\"></p>"),
                           HasSubstr("<figcaption>what frame 11 shows")));
  EXPECT_EQ(Order(plain), "2d full static ");

  // The column after sequence, variant, frames, truth, runs and coverage.
  const std::string sorted = Opened(page, "#table-values/6/descending");
  EXPECT_THAT(sorted, HasSubstr("aria-sort=\"descending\""));
  EXPECT_EQ(Order(sorted), "full 2d static ");
  EXPECT_EQ(Order(Opened(page, "#table-values/1/descending")), "static full 2d ");

  EXPECT_THAT(Opened(page, "#frames-1/10"),
              AllOf(HasSubstr("<figcaption>what frame 10 shows"),
                    ContainsRegex("<img data-frame=\"11\"[^>]*hidden"),
                    Not(ContainsRegex("<img data-frame=\"10\"[^>]*hidden"))));
  EXPECT_THAT(Opened(page, "#frames-1/20"), HasSubstr("<figcaption>what frame 12 shows"));
}

}  // namespace
}  // namespace cvo::browser_test
