// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the rules themselves: each must catch its violations, or source_tree_test proves nothing.
#include "tests/house/house_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(Includes, FollowTheLayersOfTheEstimator) {
  ExpectIncludes("core/geometry/a.h", {"\"core/base/error.h\""}, {});
  ExpectIncludes("core/features/a.cc", {}, {"\"core/estimation/window.h\""});
  ExpectIncludes("core/association/a.cc", {}, {"\"core/interface/frame.h\""});
  ExpectIncludes("core/solvers/a.cc", {}, {"\"core/estimation/window.h\""});
  ExpectIncludes("core/clusters/a.cc", {}, {"\"core/labelling/label_scene.h\""});
  ExpectIncludes("core/labelling/a.cc", {"\"core/clusters/cluster_map.h\""},
                 {"\"core/odometry/motion_model.h\""});
  ExpectIncludes("core/odometry/a.cc", {},
                 {"\"variants/registry.h\"", "\"experiments/datasets/sequence.h\""});
  ExpectIncludes("variants/a.cc", {"\"core/interface/frame.h\""},
                 {"\"experiments/runner/suite.h\""});
}

TEST(Includes, TheEstimatorUsesNoFilesJsonOrClock) {
  ExpectIncludes("core/estimation/a.cc", {"<ceres/problem.h>"},
                 {"<fstream>", "<filesystem>", "<nlohmann/json.hpp>", "<CLI/CLI.hpp>",
                  "<opencv2/imgcodecs.hpp>", "<random>", "<chrono>"});
  ExpectIncludes("core/base/stage_times.h", {"<chrono>"}, {});
}

TEST(Includes, FollowTheLayersOfTheExperiments) {
  ExpectIncludes("experiments/metrics/a.cc", {}, {"\"experiments/record/job_identity.h\""});
  ExpectIncludes("core/files/a.cc", {}, {"\"experiments/datasets/sequence.h\""});
  ExpectIncludes("experiments/datasets/a.cc", {"\"core/files/json/json.h\""},
                 {"\"experiments/runner/a.h\""});
  ExpectIncludes("experiments/record/a.cc", {"\"build_sources.h\""}, {"\"experiments/cli/a.h\""});
  ExpectIncludes("experiments/runner/a.cc", {}, {"\"reports/tables/table.h\""});
  ExpectIncludes("experiments/cli/a.cc", {"\"reports/tables/table.h\""}, {});
}

TEST(Includes, NestedFoldersAreBelowOrAboveTheirParent) {
  ExpectIncludes("core/files/a.cc", {"\"core/files/text/utf8.h\""}, {"\"core/files/json/json.h\""});
  ExpectIncludes("core/files/text/a.cc", {}, {"\"core/files/atomic_file.h\""});
  ExpectIncludes("core/files/json/a.cc", {"\"core/files/text_file.h\""}, {});
  ExpectIncludes("experiments/metrics/a.cc", {}, {"\"experiments/metrics/objects/a.h\""});
  ExpectIncludes("experiments/datasets/a.cc", {"\"experiments/metrics/objects/a.h\""}, {});
  ExpectIncludes("experiments/suite/shipped/a.cc", {}, {"\"experiments/suite/suite.h\""});
  ExpectIncludes("experiments/suite/a.cc", {"\"experiments/suite/shipped/a.h\""},
                 {"\"experiments/suite/plan/plan.h\""});
  ExpectIncludes("experiments/suite/plan/a.cc", {"\"synth/write/manifest.h\""}, {});
  ExpectIncludes("experiments/jobs/a.cc", {"\"experiments/suite/plan/plan.h\""},
                 {"\"experiments/jobs/slurm/a.h\""});
}

TEST(Includes, ReportsReadFilesOnly) {
  ExpectIncludes(
      "reports/tables/a.cc",
      {"\"core/base/error.h\"", "\"core/geometry/rigid_transform.h\"", "<Eigen/Core>"},
      {"\"core/features/orb/orb.h\"", "\"experiments/jobs/job_status.h\"", "<ceres/ceres.h>"});
}

TEST(Includes, OnlyOverlaysDraw) {
  ExpectIncludes("reports/overlays/a.cc",
                 {"<opencv2/imgproc.hpp>", "\"reports/runs/run_detail.h\"",
                  "\"core/geometry/rigid_transform.h\""},
                 {"\"experiments/cache/cache_file.h\"", "<ceres/ceres.h>"});
  ExpectIncludes("reports/page/a.cc", {}, {"<opencv2/core/mat.hpp>"});
}

TEST(Includes, SynthIncludesOnlyGeometryAndNothingIncludesTests) {
  ExpectIncludes("synth/scene/a.cc",
                 {"\"core/geometry/stereo_camera.h\"", "\"core/files/json/json.h\""},
                 {"\"experiments/datasets/sequence.h\"", "\"core/features/orb/orb.h\""});
  ExpectIncludes("synth/render/a.cc", {"\"synth/scene/world.h\""}, {});
  ExpectIncludes("synth/models/a.cc", {}, {"\"synth/scene/world.h\""});
  ExpectIncludes("experiments/cli/a.cc", {}, {"\"tests/support/temp_folder.h\""});
  ExpectIncludes("tests/core/a.cc", {"\"experiments/cli/a.h\""}, {});
  ExpectIncludes("tools/a.cc", {}, {"\"core/base/error.h\""});
}

const char kHeader[] =
    "// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors\n"
    "// SPDX-License-Identifier: Apache-2.0\n";

TEST(License, IsTwoLinesAtTheTop) {
  EXPECT_THAT(CheckLicense({"a.cc", kHeader}), IsEmpty());
  EXPECT_THAT(CheckLicense({"a.cc", ""}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"a.cc", std::string("\n") + kHeader}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"CMakeLists.txt", kHeader}), SizeIs(1));
  EXPECT_THAT(CheckLicense({"run",
                            "#!/bin/sh\n# SPDX-FileCopyrightText: 2026 A\n"
                            "# SPDX-License-Identifier: Apache-2.0\n"}),
              IsEmpty());
}

TEST(Length, IsAtMostFourHundredLines) {
  EXPECT_THAT(CheckLength({"a.cc", std::string(400, '\n')}), IsEmpty());
  EXPECT_THAT(CheckLength({"a.cc", std::string(401, '\n')}), SizeIs(1));
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
  EXPECT_THAT(CheckConcepts({{"core/a.h", "\n"}, {"core/a.cc", lines}}), IsEmpty());
  EXPECT_THAT(CheckConcepts({{"core/a.cc", std::string(59, '\n')}}),
              ElementsAre("core/a.cc:1: 59 lines, at least 60"));
}

std::vector<std::string> Text(const std::string& path, const std::string& line) {
  return CheckForbiddenText({path, "\n" + line + "\n"});
}

TEST(ForbiddenText, MacrosInTheEstimator) {
  EXPECT_THAT(Text("core/base/a.h", "#pragma once"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.h", "#ifdef X"), ElementsAre(HasSubstr("core/base/a.h:2: ")));
  EXPECT_THAT(Text("variants/a.cc", "  # if X"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.h", "#if defined(X)"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.cc", "#if defined(CVO_WITH_AVX2)"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.cc", "#if defined(__x86_64__)"), SizeIs(1));
  EXPECT_THAT(Text("core/features/cpu_level.h", "#if defined(__x86_64__)"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.h", "#define X 1"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.h", "// #define X 1"), IsEmpty());
}

TEST(ForbiddenText, FlagsAnywhere) {
  EXPECT_THAT(Text("CMakeLists.txt",
                   "add_compile_options(-march=nat"
                   "ive)"),
              SizeIs(1));
  EXPECT_THAT(Text("Makefile",
                   "CXXFLAGS += -ffast-ma"
                   "th"),
              SizeIs(1));
  EXPECT_THAT(Text("CMakeLists.txt", "add_compile_options(-mavx2)"), IsEmpty());
}

TEST(ForbiddenText, LibrariesNeitherPrintNorEndTheProcess) {
  EXPECT_THAT(Text("core/base/a.cc", "  std::cout << 1;"), SizeIs(1));
  EXPECT_THAT(Text("reports/tables/a.cc", "  printf(\"x\");"), SizeIs(1));
  EXPECT_THAT(Text("reports/tables/a.cc", "  std::snprintf(buffer, 5, \"x\");"), IsEmpty());
  EXPECT_THAT(Text("experiments/runner/a.cc", "  std::exit(1);"), SizeIs(1));
  EXPECT_THAT(Text("experiments/cli/main.cc", "  std::cerr << 1;"), IsEmpty());
}

TEST(ForbiddenText, MutableStaticsAndSleeps) {
  EXPECT_THAT(Text("core/base/a.cc", "  static int count = 0;"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.cc", "  static std::vector<int> cache;"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.cc", "thread_local bool x{};"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.cc", "  static const std::vector<int> table = Make();"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.cc", "  static constexpr int kX = 1;"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.h", "  static Foo Create(int a) {"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.cc", "  static_assert(true);"), IsEmpty());
  EXPECT_THAT(Text("core/base/a.cc", "  std::this_thread::sleep_for(1s);"), SizeIs(1));
  EXPECT_THAT(Text("core/base/a.cc", "  const double x = Operand();"), IsEmpty());
}

TEST(ForbiddenText, StepsTakeTheOptionsTheyRead) {
  EXPECT_THAT(Text("core/odometry/a.h", "void A(const Options& options);"), SizeIs(1));
  EXPECT_THAT(Text("core/bodies/a.h", "  Options options;"), SizeIs(1));
  EXPECT_THAT(Text("core/bodies/a.h", "void A(const BodyBoxOptions& options);"), IsEmpty());
  EXPECT_THAT(Text("core/odometry/visual_odometry.h", "  Options options_;"), IsEmpty());
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
