// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "reports/gate/gate_text.h"
#include "reports/gate/make_baseline.h"
#include "tests/reports/gate/gate_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::GateFolder;
using test::Json;
using test::TempFolder;
using ::testing::HasSubstr;

TEST(Baseline, ReadsBackAsWritten) {
  const GateFolder folder;
  const Baseline baseline = MakeBaseline(folder.path(), 2);
  const TempFolder temp;
  const std::string text = FileText(baseline);
  const Baseline again = ReadBaseline(temp.Write("b.json", text));
  EXPECT_EQ(FileText(again), text);
  const std::string lines = BaselineText(baseline);
  EXPECT_EQ(ParseJson(lines, "lines"), ParseJson(text, "text"));
  EXPECT_EQ(
      static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')),
      baseline.metrics.size() + baseline.jobs.size() + 11);  // braces, 7 keys, 2 ends of lists
  EXPECT_EQ(again.suite, "gate");
  EXPECT_EQ(again.build.identity, "abc");
  EXPECT_EQ(again.build.commit, "0123456789abcdef");
  EXPECT_EQ(again.seeds, (std::vector<std::uint64_t>{1, 2}));
  ASSERT_EQ(again.metrics.size(), 2U) << "coverage comes with the error that it is about";
  ASSERT_EQ(again.jobs.size(), 16U);
  EXPECT_EQ(again.jobs[0].values.at("camera_ate"), GateFolder::Ate("room", 1));
  EXPECT_EQ(again.jobs[0].time_ratio, 3.0);
  EXPECT_FALSE(again.jobs[1].time_ratio) << "of static itself";
}

TEST(Baseline, RequiresACompleteSuite) {
  const GateFolder folder;
  std::filesystem::remove_all(folder.path() / "jobs" / GateFolder::Id("room", "full", 3));
  EXPECT_THAT(ErrorMessage([&] { MakeBaseline(folder.path()); }),
              HasSubstr("full on room, detections good, seed 3: found not run"));
}

TEST(Baseline, NeedsTwoSeeds) {
  const GateFolder folder(1);
  EXPECT_THAT(ErrorMessage([&] { MakeBaseline(folder.path()); }), HasSubstr("found 1 seed,"));
  const GateFolder two(2);
  EXPECT_THAT(ErrorMessage([&] { MakeBaseline(two.path(), 3); }), HasSubstr("found 2 seeds"));
}

TEST(Baseline, NeedsOneContractPerMetric) {
  const GateFolder folder;
  folder.Edit(GateFolder::Id("street", "full", 2),
              [](Json& result) { result["metrics"][1]["contract"]["truth"] = "interpolated"; });
  EXPECT_THAT(ErrorMessage([&] { MakeBaseline(folder.path()); }), HasSubstr("another contract"));
}

TEST(Baseline, BadFilesGiveErrorsOfOneLine) {
  const GateFolder folder;
  const std::string good = FileText(MakeBaseline(folder.path()));
  const TempFolder temp;
  const auto message = [&](const std::function<void(Json&)>& edit) {
    Json json = Json::parse(good);
    edit(json);
    const auto file = temp.Write("b.json", json.dump());
    const std::string text = ErrorMessage([&] { ReadBaseline(file); });
    EXPECT_EQ(text.find('\n'), std::string::npos);
    return text;
  };
  EXPECT_EQ(message([](Json&) {}), "");
  EXPECT_THAT(message([](Json& json) { json["schema_version"] = 7; }), HasSubstr("found schema"));
  EXPECT_THAT(message([](Json& json) { json["kind"] = "plan"; }), HasSubstr("kind \"plan\""));
  EXPECT_THAT(message([](Json& json) { json["metrics"][0]["better"] = "lower"; }),
              HasSubstr("expected \"higher\""));
  EXPECT_THAT(message([](Json& json) { json["metrics"][0]["name"] = "wall_s"; }),
              HasSubstr("a metric that the gate knows"));
  EXPECT_THAT(message([](Json& json) { json["metrics"].erase(1); }),
              HasSubstr("a value of camera_ate"));
  EXPECT_THAT(message([](Json& json) { json["jobs"].push_back(json["jobs"][0]); }),
              HasSubstr("twice"));
  EXPECT_THAT(message([](Json& json) { json["jobs"] = Json::array(); }), HasSubstr("no value"));
  EXPECT_THAT(message([](Json& json) { json["jobs"][0]["keys"].erase("variant"); }),
              HasSubstr("variant and sequence"));
  EXPECT_THAT(message([](Json& json) { json["jobs"][0]["values"]["camera_ate"] = nullptr; }),
              HasSubstr("a JSON null, expected a number"));
  EXPECT_THAT(message([](Json& json) { json["seeds"] = {-1}; }), HasSubstr("an integer from 0"));
  const auto cut = temp.Write("cut.json", good.substr(0, good.size() / 2));
  EXPECT_THAT(ErrorMessage([&] { ReadBaseline(cut); }), HasSubstr("one complete JSON value"));
}

GateReport HandMadeReport() {
  GateReport report;
  report.suite = "ci";
  report.baseline_commit = "abc";
  report.runs = 2;
  report.comparisons = {{"full", "", "camera_ate", "m", 1.0, 2.0, 0.5, 2, Verdict::kWorse},
                        {"full", "a<b", "moving_recall", "1", 0.5, 0.5, 0.1, 2, Verdict::kSame}};
  report.problems = {{"2d on \"room\" & more", "bad | <\x01>\nline"}};
  return report;
}

TEST(GateText, JunitIsEscapedAndHasCounts) {
  const std::string xml = GateJunit(HandMadeReport());
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"clustervo.ci\" tests=\"3\" failures=\"2\""));
  EXPECT_THAT(xml, HasSubstr("classname=\"clustervo.ci.full\" name=\"camera_ate\" time=\"0\">"
                             "<failure message=\"2, in the baseline 1: +1, tolerance 0.5\"/>"));
  EXPECT_THAT(xml, HasSubstr("name=\"moving_recall on a&lt;b\" time=\"0\"/>"));
  EXPECT_THAT(xml, HasSubstr("name=\"2d on &quot;room&quot; &amp; more\" time=\"0\">"
                             "<failure message=\"bad | &lt;\uFFFD&gt; line\"/>"));
  EXPECT_EQ(std::count(xml.begin(), xml.end(), '\x01'), 0);
}

TEST(GateText, MarkdownIsATable) {
  const std::string text = GateMarkdown(HandMadeReport());
  EXPECT_THAT(text, HasSubstr("### Regression\n\nci: 2 runs compared with those of abc: 1 worse"));
  EXPECT_THAT(text,
              HasSubstr("| full | all | camera\\_ate (m) | 1 | 2 | +1 | 0.5 | 2 | WORSE |\n"));
  EXPECT_THAT(text, HasSubstr("- 2d on \"room\" \\& more: bad \\| \\<"));
  GateReport good = HandMadeReport();
  good.problems.clear();
  good.comparisons.erase(good.comparisons.begin());
  EXPECT_THAT(GateMarkdown(good), HasSubstr("### No regression"));
}

TEST(GateText, LongListsOfProblemsAreTruncated) {
  GateReport report = HandMadeReport();
  report.problems.assign(50, {"a", "b"});
  EXPECT_EQ(ProblemLines(report).size(), 21U);
  EXPECT_EQ(ProblemLines(report).back(), "and 30 more");
  report.changed = 1;  // takes a line of its own
  EXPECT_EQ(ProblemLines(report).back(), "and 30 more");
}

}  // namespace
}  // namespace cvo::reports
