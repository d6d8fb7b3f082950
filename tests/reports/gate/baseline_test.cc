// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/baseline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "reports/gate/check_runs.h"
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
      baseline.metrics.size() + baseline.jobs.size() + 13);  // braces, 9 keys, 2 ends of lists
  EXPECT_EQ(again.suite, "gate");
  EXPECT_EQ(again.build.identity, "abc");
  EXPECT_EQ(again.build.commit, "0123456789abcdef");
  EXPECT_EQ(again.seeds, (std::vector<std::uint64_t>{1, 2}));
  ASSERT_EQ(again.metrics.size(), 2U) << "coverage comes with the error that it is about";
  ASSERT_EQ(again.jobs.size(), 16U);
  EXPECT_EQ(again.jobs[0].values.at("camera_ate"), GateFolder::Ate("room", 1));
}

TEST(Baseline, RequiresACompleteSuiteWithTwoSeedsAndOneContractPerMetric) {
  const auto error = [](const GateFolder& folder, std::size_t seeds = 0) {
    return ErrorMessage([&] { MakeBaseline(folder.path(), seeds); });
  };
  EXPECT_THAT(error(GateFolder(1)), HasSubstr("found 1 seed,"));
  EXPECT_THAT(error(GateFolder(2), 3), HasSubstr("found 2 seeds"));
  const GateFolder folder;
  folder.Edit(GateFolder::Id("street", "full", 2),
              [](Json& result) { result["metrics"][1]["contract"]["truth"] = "official"; });
  EXPECT_THAT(error(folder), HasSubstr("another contract"));
  std::filesystem::remove_all(folder.path() / "jobs" / GateFolder::Id("room", "full", 3));
  EXPECT_THAT(error(folder), HasSubstr("full on room, detections good, seed 3: found not run"));
}

TEST(Baseline, AGateThatWouldMissADoublingIsRefused) {
  const GateFolder few(2);
  EXPECT_THAT(
      ErrorMessage([&] { MakeBaseline(few.path()); }),
      testing::AllOf(HasSubstr("found camera_ate of full that gets worse by "),
                     HasSubstr("3 seeds (experiment run --seeds 3, check --gate-seeds 3;")));
  // Twice as many names for the same images are not more scenes.
  const GateFolder alike(5);
  const auto tolerance = [&] { return NoticedBy(MakeBaseline(alike.path())).at(1).tolerance; };
  const double of_two = tolerance();
  alike.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
    alike.Edit(GateFolder::Id(scene, variant, seed), [&](Json& result) {
      result["sequence"]["images"] = "the same";
      result["metrics"][1]["value"] = GateFolder::Ate("room", seed);
    });
  });
  EXPECT_GT(tolerance(), 1.3 * of_two);
  alike.EditPlan([](Json& plan) { plan["table"]["metrics"] = {"camera_coverage"}; });
  EXPECT_EQ(NoticedBy(MakeBaseline(alike.path())).at(1).metric, "camera_ate")
      << "whatever the table shows";
  EXPECT_THAT(NoticedText(MakeBaseline(GateFolder().path())), HasSubstr("camera_ate       "));
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
  EXPECT_THAT(message([](Json& json) { json["seeds"] = Json::array(); }), HasSubstr("found none"));
  EXPECT_THAT(message([](Json& json) { json["seeds"] = {1, 77}; }), HasSubstr("found 77"));
  EXPECT_THAT(message([](Json& json) { json["metrics"].push_back(json["metrics"][0]); }),
              HasSubstr("camera_coverage twice"));
  EXPECT_THAT(message([](Json& json) { json["jobs"][0]["values"]["camera_ate"] = 0.5; }),
              HasSubstr("does not fit its checksum"));
  const auto cut = temp.Write("cut.json", good.substr(0, good.size() / 2));
  EXPECT_THAT(ErrorMessage([&] { ReadBaseline(cut); }), HasSubstr("one complete JSON value"));
}

}  // namespace
}  // namespace cvo::reports
