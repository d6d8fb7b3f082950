// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo plot` as a process: its summary of trajectories, its output files and its errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text/number.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
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

class CliPlot : public testing::Test {
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
  std::string out(const std::string& name = "plot.html") const {
    return (folder_.path() / name).string();
  }
  ProcessResult Plot(std::vector<std::string> arguments,
                     const std::string& name = "plot.html") const {
    arguments.insert(arguments.begin(), "plot");
    arguments.insert(arguments.end(), {"-o", out(name)});
    return RunProgram(arguments);
  }

  test::TempFolder folder_;
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
  const std::vector<std::string> both = {turned, "--groundtruth", truth};
  const auto plot_with = [&](const std::string& alignment) {
    std::vector<std::string> arguments = both;
    arguments.insert(arguments.end(), {"--align", alignment});
    const ProcessResult run = Plot(arguments);
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
              AllOf(HasSubstr("<h1>Trajectory against truth</h1>"),
                    HasSubstr("Aligned by SE(3) over positions; poses matched within 0.02 s"),
                    HasSubstr("turned: "), Not(HasSubstr("http-equiv"))));
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
  const fs::path tiny = folder_.path() / "tiny";
  test::WriteTinySequence(tiny, 6);
  const fs::path results = folder_.path() / "results";
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
  ExpectError(Plot({truth}, "plot.png"), "expected a name that ends in .svg, .pdf or .html", 2);
  ExpectError(Plot({truth, "--align", "se3"}), "--align: needs --groundtruth", 2);
  ExpectError(Plot({folder_.path().string()}), "found a folder without result.json");
  ExpectError(Plot({folder_.Write("bad.txt", "1 2 3\n").string()}), "bad.txt:1: found 3 columns");
  ExpectError(Plot({folder_.Write("comma.csv", "1,2,3\n").string()}), "comma.csv:1: found 3 col");
  ExpectError(Plot({(folder_.path() / "none.txt").string()}), "none.txt");
  ExpectError(Plot({Tum("one.txt", 0.0, 1), "--groundtruth", truth}),
              "one.txt: found 1 poses that match one of truth, expected 2 or more within 0.02 s");
  ExpectError(Plot({truth}, "truth.txt/plot.html"), "truth.txt");
  ExpectError(RunProgram({"plot", truth, "-o", out("plot.svg")},
                         {.environment = {"CLUSTERVO_BROWSER=/nowhere"}}),
              "/nowhere: found a program that cannot be run, expected a Chromium");
  EXPECT_FALSE(fs::exists(out())) << "nothing is written";
}

TEST_F(CliPlot, BrowserDrawingsAreReproducible) {
  const char* chosen = std::getenv("CLUSTERVO_BROWSER");
  if (::access(chosen != nullptr ? chosen : "/usr/bin/chromium", X_OK) != 0) {
    GTEST_SKIP() << "no Chromium: /usr/bin/chromium or CLUSTERVO_BROWSER";
  }
  const std::vector<std::string> arguments = {Tum("a.txt"), Tum("b<i>.txt", 2.0)};
  ASSERT_EQ(Plot(arguments, "plot.svg").exit_code, 0);
  const std::string svg = test::ReadFile(out("plot.svg"));
  EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr("Trajectories against a"),
                         HasSubstr("distance (m)"), HasSubstr("b&#60;i&#62;")));
  ASSERT_EQ(Plot(arguments, "plot.svg").exit_code, 0);
  EXPECT_EQ(test::ReadFile(out("plot.svg")), svg);
  ASSERT_EQ(Plot(arguments, "plot.pdf").exit_code, 0);
  EXPECT_THAT(test::ReadFile(out("plot.pdf")), StartsWith("%PDF-"));
}

}  // namespace
}  // namespace cvo
