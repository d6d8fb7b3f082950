// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the rules themselves: each must catch its violations, or source_tree_test proves nothing.
#include "tests/house/house_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace cvo::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> Include(const std::string& path, const std::string& header) {
  return CheckIncludes({path, "#pragma once\n\n  #  include " + header + "  // why\n"});
}

void ExpectIncludes(const std::string& path, const std::vector<const char*>& allowed,
                    const std::vector<const char*>& refused) {
  for (const char* header : allowed) EXPECT_THAT(Include(path, header), IsEmpty());
  for (const char* header : refused) EXPECT_THAT(Include(path, header), SizeIs(1)) << header;
}

TEST(Includes, NamePlaceAndRule) {
  EXPECT_THAT(Include("core/base/a.h", "\"core/geometry/rigid_transform.h\""),
              ElementsAre("core/base/a.h:3: core/base/ must not include "
                          "core/geometry/rigid_transform.h"));
}

TEST(Includes, FollowTheLayers) {
  ExpectIncludes("core/geometry/a.h", {"\"core/base/error.h\""}, {});
  ExpectIncludes("core/association/a.cc", {}, {"\"core/interface/frame.h\""});
  ExpectIncludes("core/labelling/a.cc", {"\"core/clusters/cluster_map.h\""},
                 {"\"core/odometry/motion_model.h\""});
  ExpectIncludes("core/odometry/a.cc", {},
                 {"\"variants/registry.h\"", "\"experiments/datasets/sequence.h\""});
  ExpectIncludes("variants/a.cc", {"\"core/interface/frame.h\""},
                 {"\"experiments/runner/suite.h\""});
  ExpectIncludes("experiments/runner/a.cc", {"\"build_sources.h\""}, {"\"experiments/cli/a.h\""});
  ExpectIncludes("experiments/suite/a.cc", {"\"synth/write/manifest.h\""},
                 {"\"reports/tables/table.h\""});
  ExpectIncludes("experiments/cli/a.cc", {"\"reports/tables/table.h\""},
                 {"\"tests/support/temp_folder.h\""});
  ExpectIncludes("synth/render/a.cc", {"\"synth/scene/world.h\"", "\"core/files/json/json.h\""},
                 {"\"core/features/orb/orb.h\""});
  ExpectIncludes("synth/models/a.cc", {}, {"\"synth/scene/world.h\""});
  ExpectIncludes("tests/core/a.cc", {"\"experiments/cli/a.h\""}, {});
  ExpectIncludes("tools/a.cc", {}, {"\"core/base/error.h\""});
}

TEST(Includes, TheEstimatorUsesNoFilesJsonOrClock) {
  ExpectIncludes("core/estimation/a.cc", {"<ceres/problem.h>"},
                 {"<fstream>", "<filesystem>", "<nlohmann/json.hpp>", "<CLI/CLI.hpp>",
                  "<opencv2/imgcodecs.hpp>", "<random>", "<chrono>"});
  ExpectIncludes("core/base/stage_times.h", {"<chrono>"}, {});
}

TEST(Includes, NestedFoldersAreBelowOrAboveTheirParent) {
  ExpectIncludes("core/files/a.cc", {"\"core/files/text/utf8.h\""}, {"\"core/files/json/json.h\""});
  ExpectIncludes("core/files/text/a.cc", {}, {"\"core/files/atomic_file.h\""});
  ExpectIncludes("core/files/json/a.cc", {"\"core/files/text_file.h\""}, {});
}

TEST(Includes, ReportsReadFilesAndOnlyOverlaysDraw) {
  ExpectIncludes("reports/tables/a.cc", {"\"core/geometry/rigid_transform.h\"", "<Eigen/Core>"},
                 {"\"core/features/orb/orb.h\"", "\"experiments/suite/job_status.h\"",
                  "<ceres/ceres.h>", "<opencv2/core/mat.hpp>"});
  ExpectIncludes("reports/overlays/a.cc", {"<opencv2/imgproc.hpp>"},
                 {"\"experiments/runner/cache_file.h\"", "<ceres/ceres.h>"});
}

const char kHeader[] =
    "// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors\n"
    "// SPDX-License-Identifier: Apache-2.0\n";

TEST(Files, HaveTwoLinesOfLicenseAndAtMostFourHundred) {
  EXPECT_THAT(CheckLength({"a.cc", std::string(400, '\n')}), IsEmpty());
  EXPECT_THAT(CheckLength({"a.cc", std::string(401, '\n')}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"a.cc", kHeader}), IsEmpty());
  EXPECT_THAT(CheckLicense({"a.cc", ""}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"a.cc", std::string("\n") + kHeader}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"CMakeLists.txt", kHeader}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"run",
                            "#!/bin/sh\n# SPDX-FileCopyrightText: 2026 A\n"
                            "# SPDX-License-Identifier: Apache-2.0\n"}),
              IsEmpty());
}

TEST(Concepts, AreNeitherShortNorAHeaderOfOneFile) {
  const std::string lines(60, '\n');
  const SourceFile header{"core/a.h", lines};
  const SourceFile own{"core/a.cc", "#include \"core/a.h\"" + lines};
  const SourceFile user{"core/b.cc", "#include \"core/a.h\"" + lines};
  const SourceFile test{"tests/core/a_test.cc", "#include \"core/a.h\"" + lines};
  EXPECT_THAT(CheckConcepts({header, own, user, test}), IsEmpty());
  EXPECT_THAT(CheckConcepts({header, own, user}),
              ElementsAre("core/a.h:1: only core/b.cc includes it: it belongs there"));
  EXPECT_THAT(CheckConcepts({header, {"core/a.cc", std::string(300, '\n')}, user}), IsEmpty());
  EXPECT_THAT(CheckConcepts({{"core/a.h", "\n"}, {"core/a.cc", lines}}), IsEmpty());
  EXPECT_THAT(CheckConcepts({{"core/a.cc", std::string(59, '\n')}}),
              ElementsAre("core/a.cc:1: 59 lines, at least 60, or 3 files that include it"));
  const SourceFile another{"core/c.cc", "#include \"core/a.h\"" + lines};
  EXPECT_THAT(CheckConcepts({{"core/a.h", "\n"}, user, test, another}), IsEmpty());
}

// Two flags are in two literals, or the rule would match this file.
TEST(ForbiddenText, IsFoundWhereARuleApplies) {
  struct Line {
    const char* path;
    std::string text;
    bool good;
  };
  const std::vector<Line> lines = {
      {"core/base/a.h", "#pragma once", true},
      {"core/base/a.h", "#ifdef X", false},
      {"variants/a.cc", "  # if X", false},
      {"core/base/a.cc", "#if defined(__x86_64__)", false},
      {"core/features/processor.h", "#if defined(__x86_64__)", true},
      {"core/base/a.h", "#define X 1", false},
      {"core/base/a.h", "// #define X 1", true},
      {"CMakeLists.txt", std::string("add_compile_options(-march=") + "native)", false},
      {"Makefile", std::string("CXXFLAGS += -ffast-") + "math", false},
      {"CMakeLists.txt", "add_compile_options(-mavx2)", true},
      {"core/base/a.cc", "  std::cout << 1;", false},
      {"reports/tables/a.cc", "  printf(\"x\");", false},
      {"reports/tables/a.cc", "  std::snprintf(buffer, 5, \"x\");", true},
      {"experiments/runner/a.cc", "  std::exit(1);", false},
      {"experiments/cli/main.cc", "  std::cerr << 1;", true},
      {"core/base/a.cc", "  static int count = 0;", false},
      {"core/base/a.cc", "  static std::vector<int> cache;", false},
      {"core/base/a.cc", "thread_local bool x{};", false},
      {"core/base/a.cc", "  static const std::vector<int> table = Make();", true},
      {"core/base/a.h", "  static Foo Create(int a) {", true},
      {"core/base/a.cc", "  static_assert(true);", true},
      {"core/base/a.cc", "  std::this_thread::sleep_for(1s);", false}};
  for (const Line& line : lines) {
    const auto found = CheckForbiddenText({line.path, "\n" + line.text + "\n"});
    if (line.good) {
      EXPECT_THAT(found, IsEmpty()) << line.text;
    } else {
      EXPECT_THAT(found, ElementsAre(HasSubstr(StrCat(line.path, ":2: ")))) << line.text;
    }
  }
}

TEST(Registered, EverySourceIsNamedByACMakeLists) {
  const SourceFile named{"tests/core/a_test.cc", ""};
  const SourceFile nested{"tests/core/deep/b_test.cc", ""};
  const SourceFile forgotten{"tests/core/a_test2.cc", ""};
  const SourceFile cmake{"tests/core/CMakeLists.txt",
                         "cvo_test(x SOURCES a_test.cc\n  deep/b_test.cc)"};
  EXPECT_THAT(CheckRegistered({named, nested, cmake}), IsEmpty());
  EXPECT_THAT(CheckRegistered({named, forgotten, cmake}),
              ElementsAre("tests/core/a_test2.cc:1: named by no CMakeLists.txt"));
  EXPECT_THAT(CheckRegistered({named}), SizeIs(1));
}

TEST(CheckTypeNames, FindsTheSameNameTwiceInOneNamespace) {
  const std::string text = "namespace a {\n\nstruct Thing {\n};\n";
  EXPECT_THAT(CheckTypeNames({{"x/one.h", text}, {"y/two.h", text}}),
              ElementsAre("y/two.h:3: a::Thing is defined in x/one.h:3"));
  EXPECT_THAT(CheckTypeNames({{"x/one.h", text}, {"y/two.h", "namespace b {\nclass Thing {\n"}}),
              IsEmpty());
}

TEST(Citations, NameExistingFiles) {
  const std::vector<SourceFile> documents = {{"core/METHOD.md", "## 4 Boxes\n### 4.2 Gate\n"},
                                             {"README.md", "see core/METHOD.md\n"}};
  const auto check = [&](const std::string& text) {
    return CheckCitations({{"core/gate.cc", text}}, documents);
  };
  EXPECT_THAT(check("// METHOD.md 4.2, METHOD.md 4\n// README.md\n"), IsEmpty());
  EXPECT_THAT(check("\n// (METHOD.md 4.3)"),
              ElementsAre("core/gate.cc:2: METHOD.md has no section 4.3"));
  const std::string gone = std::string("gone") + ".md";  // or this file would cite it
  EXPECT_THAT(check("// as " + gone + " says"),
              ElementsAre(HasSubstr("no such document in the repository: " + gone)));
  EXPECT_THAT(check("// the " + std::string("design") + " notes"), SizeIs(1));
}

TEST(Citations, TheMethodNamesExistingFilesAndOptions) {
  const std::vector<SourceFile> files = {
      {"core/gate.h", "visit.Group(\"orb\", x);\nvisit.Field(\n    \"levels\", y);\n"}};
  const auto check = [&](const std::string& text) {
    return CheckCitations(files, {{"core/METHOD.md", text}});
  };
  EXPECT_THAT(check("Files: `gate.h`. Option `orb.levels`.\n"), IsEmpty());
  EXPECT_THAT(check("\nFiles: `lost.cc`\n"),
              ElementsAre("core/METHOD.md:2: no such file: `lost.cc`"));
  EXPECT_THAT(check("`orb.none` `none.levels`\n"), SizeIs(2));
}

}  // namespace
}  // namespace cvo::test
