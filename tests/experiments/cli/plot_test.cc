// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo plot` as a process: its summary of trajectories, its output files, its errors
// and the figures of a suite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/reports/results/result_files.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::BodyOf;
using test::ExpectError;
using test::ProcessResult;
using test::ProcessSetup;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr int kPoses = 12;
constexpr double kTau = 6.283185307179586;

// A quarter circle of radius 1 m with a hill.
struct PathPoint {
  double x, y, z;
};
PathPoint PointAt(int i) {
  const double angle = kTau / 4.0 * i / kPoses;
  return {std::sin(angle), 0.1 * std::sin(3.0 * angle), 1.0 - std::cos(angle)};
}

class CliPlot : public test::CommandTest {
 protected:
  // If `scale` is positive, the path is rotated by 90 degrees about y and scaled: (x, y, z) becomes
  // s (z, y, -x).
  std::string Tum(const std::string& name, double scale = 0.0, int poses = kPoses) const {
    std::ostringstream text;
    for (int i = 0; i < poses; ++i) {
      const auto [x, y, z] = PointAt(i);
      text << 100 + 0.1 * i << ' ';
      if (scale > 0.0) {
        text << scale * z << ' ' << scale * y << ' ' << -scale * x;
      } else {
        text << x << ' ' << y << ' ' << z;
      }
      text << " 0 0 0 1\n";
    }
    return folder_.Write(name, text.str()).string();
  }
  std::string Kitti(const std::string& name, int poses = kPoses) const {
    std::ostringstream text;
    for (int i = 0; i < poses; ++i) {
      const auto [x, y, z] = PointAt(i);
      text << "1 0 0 " << x << " 0 1 0 " << y << " 0 0 1 " << z << '\n';
    }
    return folder_.Write(name, text.str()).string();
  }
  std::string out(const std::string& name = "plot.svg") const { return Path(name); }
  ProcessResult Plot(Arguments arguments, const std::string& name = "plot.svg") const {
    arguments.insert(arguments.begin(), "plot");
    arguments.insert(arguments.end(), {"-o", out(name)});
    return RunProgram(arguments);
  }
};

// Returns the value of the first trajectory in the column of the summary with this heading.
double SummaryValue(const std::string& text, const std::string& heading) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("trajectory  ")) {
  }
  const std::size_t column = line.find(heading);
  std::getline(lines, line);
  std::istringstream cell(line.substr(std::min(column, line.size())));
  double value = -1.0;
  cell >> value;
  return value;
}

TEST_F(CliPlot, AlignmentIsChosenAndNamed) {
  const std::string truth = Tum("truth.txt");
  const std::string turned = Tum("turned.txt", 2.0);
  const Arguments both = {turned, "--groundtruth", truth};
  const auto plot_with = [&](const std::string& alignment) {
    const ProcessResult run = Plot(With(both, {"--align", alignment}));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  };
  const std::string scaled = plot_with("sim3");
  EXPECT_LT(SummaryValue(scaled, "rms m"), 1e-5) << scaled;
  EXPECT_NEAR(SummaryValue(scaled, "scale"), 0.5, 1e-4);
  EXPECT_EQ(SummaryValue(scaled, "matched"), kPoses);
  EXPECT_GT(SummaryValue(plot_with("none"), "rms m"), 0.5);
  EXPECT_GT(SummaryValue(plot_with("se3"), "rms m"), 0.1);
  EXPECT_THAT(test::ReadFile(out()),
              AllOf(StartsWith("<svg"), HasSubstr(">Trajectories against truth<"),
                    HasSubstr("Aligned by SE(3) over positions; poses matched within 0.02 s"),
                    HasSubstr(">turned: ")));
}

TEST_F(CliPlot, ReadsCommaSeparatedEurocFiles) {
  std::ostringstream text;
  text << "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_w, q_x, q_y, q_z, v_x\n";
  for (int i = 0; i < kPoses; ++i) {
    const auto [x, y, z] = PointAt(i);
    text << 100 + i / 10 << i % 10 << "00000000," << x << ',' << y << ',' << z << ",1,0,0,0,0.5\n";
  }
  const std::string truth = folder_.Write("data.csv", text.str()).string();
  const ProcessResult run = Plot({Tum("mine.txt"), "--groundtruth", truth, "--align", "none"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(SummaryValue(run.out, "rms m"), 1e-9) << run.out;
}

TEST_F(CliPlot, KittiPosesAreMatchedByLineNumber) {
  const ProcessResult run = Plot({Tum("mine.txt"), "--groundtruth", Kitti("06.txt")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("poses matched by line number"));
  EXPECT_LT(SummaryValue(run.out, "rms m"), 1e-5) << run.out;
  ExpectError(Plot({Kitti("short.txt", 5), "--groundtruth", Kitti("06.txt")}),
              "06.txt: found 12 poses, expected 5, as many as ");
}

TEST_F(CliPlot, PlotsARunAgainstItsTruthWithTheErrorOfItsResult) {
  const fs::path tiny = Path("tiny");
  test::WriteTinySequence(tiny, 6);
  const fs::path results = Path("results");
  const ProcessResult made =
      RunProgram({"run", tiny.string(), "-o", results.string(), "--variant", "static"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const ProcessResult run = Plot({results.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json result = ParseJson(test::ReadFile(results / "result.json"), "result");
  double ate_m = -1.0;
  for (const Json& metric : result["metrics"]) {
    if (metric["name"] == "camera_ate") ate_m = metric["value"].get<double>();
  }
  EXPECT_NEAR(SummaryValue(run.out, "rms m") / ate_m, 1.0, 1e-3) << run.out;
  const ProcessResult twice = Plot({results.string(), (results / "camera.tum").string()});
  EXPECT_THAT(twice.out, AllOf(HasSubstr("\nstatic "), HasSubstr("\ncamera ")));
}

TEST_F(CliPlot, BadInputGivesOneLine) {
  const std::string truth = Tum("truth.txt");
  ExpectError(Plot({truth}, "plot.html"), "expected a name that ends in .svg or .pdf", 2);
  ExpectError(Plot({truth, "--only", "x"}), "--only: applies to a suite", 2);
  ExpectError(Plot({truth, "--align", "se3"}), "--align: needs --groundtruth", 2);
  ExpectError(Plot({folder_.path().string()}), "found a folder without result.json or plan.json");
  ExpectError(Plot({folder_.Write("bad.txt", "1 2 3\n").string()}), "bad.txt:1: found 3 columns");
  ExpectError(Plot({folder_.Write("comma.csv", "1,2,3\n").string()}),
              "comma.csv:1: found 1 columns");
  ExpectError(Plot({Path("none.txt")}), "none.txt");
  ExpectError(Plot({Tum("one.txt", 0.0, 1), "--groundtruth", truth}),
              "one.txt: found 1 poses that match one of truth, at 100.000000000 to 100.000000000 "
              "s, expected "
              "2 or more within 0.02 s of 100.0");
  ExpectError(Plot({truth}, "truth.txt/plot.svg"), "truth.txt");
  ExpectError(RunProgram({"plot", truth, "-o", out("plot.pdf")},
                         {.environment = {"PATH=" + folder_.path().string()}}),
              "pdf: found no rsvg-convert in PATH");
  EXPECT_FALSE(fs::exists(out())) << "nothing is written";
}

// The figures of a suite, on hand-made results.

constexpr char kHostile[] = "room <script>alert(1)</script>";

// Two variants on one sequence whose name contains markup.
struct HostileSuite : test::SuiteResults {
  HostileSuite() {
    table["rows"] = {"sequence", "variant"};
    table["reference"] = "full";
    for (const auto& [variant, error_m] : {std::pair{"full", 0.02}, {"2d", 0.04}}) {
      Json bodies = Json::array();
      for (int id = 1; id <= 7; ++id) bodies.push_back(BodyOf(id, {error_m, error_m, -1.0}));
      Add(test::WithBodies(test::Result(kHostile), bodies), variant, 1);
    }
  }
  fs::path out() const { return folder().path() / "figures"; }
  ProcessResult Draw(Arguments more, const ProcessSetup& setup = {}) const {
    const Arguments arguments = With({"plot", Written().string(), "-o", out().string()}, more);
    return RunProgram(arguments, setup);
  }
};

TEST(CliFigures, NamesStayTextAndBytesAreReproducible) {
  const HostileSuite suite;
  const ProcessResult run = suite.Draw({});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("ablation.svg: Paired difference from full"),
                             HasSubstr("\nnot drawn: ")));
  const std::string svg = test::ReadFile(suite.out() / "ablation.svg");
  EXPECT_THAT(svg, StartsWith("<svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("Paired difference from full"),
                         HasSubstr("room &lt;script&gt;alert(1)&lt;/script&gt;"),
                         Not(HasSubstr("<script"))));
  suite.Draw({});
  EXPECT_EQ(test::ReadFile(suite.out() / "ablation.svg"), svg);
}

TEST(CliFigures, WidthAndFontAreFlags) {
  const HostileSuite suite;
  const ProcessResult run = suite.Draw({"--width-mm", "85", "--font-pt", "7", "--no-title"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(test::ReadFile(suite.out() / "ablation.svg"),
              AllOf(HasSubstr("width=\"85mm\""), HasSubstr("font-size=\"7\""),
                    Not(HasSubstr("Paired difference"))));
}

TEST(CliFigures, DrawsOneFigureByName) {
  const HostileSuite suite;
  const ProcessResult run = suite.Draw({"--only", "ablation"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(suite.out() / "ablation.svg"));
  EXPECT_THAT(run.out, Not(HasSubstr("not drawn")));
  ExpectError(suite.Draw({"--only", "abalation"}),
              "--only: found \"abalation\" (did you mean ablation?), expected one of: ", 2);
}

TEST(CliFigures, BadInputGivesOneLine) {
  const HostileSuite suite;
  const test::TempFolder empty;
  ExpectError(suite.Draw({"--format", "pdf"}, {.environment = {"PATH=" + empty.path().string()}}),
              "pdf: found no rsvg-convert in PATH, expected it");
  EXPECT_FALSE(fs::exists(suite.out())) << "nothing is left of what was not made";
  const ProcessResult usage = suite.Draw({"--format", "png"});
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_EQ(test::LineCount(usage.err), 1U);
  ExpectError(suite.Draw({"--align", "se3"}), "--align: applies to trajectories", 2);
  ExpectError(suite.Draw({"truth.txt"}), "found the folder of a suite, expected it alone", 2);
}

TEST(CliFigures, DrawsNothingForASuiteThatHasNotRun) {
  test::SuiteResults suite;
  suite.Plan("room", "full");
  const fs::path out = suite.folder().path() / "figures";
  const ProcessResult run = RunProgram({"plot", suite.Written().string(), "-o", out.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("not drawn: Differences from the reference: "));
  EXPECT_FALSE(fs::exists(out));
}

TEST(CliFigures, PdfIsReproducible) {
  const HostileSuite suite;
  const Arguments one = {"--only", "ablation", "--format", "pdf"};
  const ProcessResult run = suite.Draw(one);
  if (run.err.find("no rsvg-convert") != std::string::npos) GTEST_SKIP() << run.err;
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string pdf = test::ReadFile(suite.out() / "ablation.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  suite.Draw(one);
  EXPECT_TRUE(test::ReadFile(suite.out() / "ablation.pdf") == pdf);
}

}  // namespace
}  // namespace cvo
