// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/make_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "reports/tables/cells.h"
#include "tests/reports/results/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using test::Result;
using test::SuiteResults;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class MakeTableTest : public testing::Test {
 protected:
  Table Make(const std::string& defaults = "") const {
    return MakeTable(suite_.Written(), {}, defaults);
  }
  std::string MakeError() const {
    return ErrorMessage([this] { Make(); });
  }

  SuiteResults suite_;
};

TEST_F(MakeTableTest, OneRun) {
  suite_.Add(Result());
  const Table table = Make();
  EXPECT_EQ(table.title, "small");
  EXPECT_EQ(table.about, "what it is");
  ASSERT_THAT(table.columns, SizeIs(2));
  EXPECT_EQ(table.columns[0].metric, "camera_coverage") << "never accuracy without coverage";
  EXPECT_EQ(table.columns[1].label, "camera ATE");
  EXPECT_EQ(table.columns[1].contract.truth, std::nullopt);
  EXPECT_EQ(table.columns[1].contract.poses, PoseTime::kRefined);
  ASSERT_THAT(table.rows, SizeIs(1));
  const Row& row = table.rows[0];
  EXPECT_THAT(row.keys, ElementsAre("2011_09_26_drive_0001", "static"));
  EXPECT_EQ(row.truth.truth, TruthSource::kDevkit);
  ASSERT_THAT(row.runs, SizeIs(1));
  EXPECT_EQ(row.runs[0].result, "jobs/job0/result.json");
  EXPECT_EQ(row.cells[1].value, 0.0625);
  EXPECT_EQ(row.cells[1].n.runs, 1U);
  EXPECT_FALSE(row.cells[1].interval.has_value());
  EXPECT_THAT(table.notes, IsEmpty());
  EXPECT_TRUE(IsComplete(table));
}

TEST_F(MakeTableTest, SeedsAreAveragedPerScene) {
  for (const int seed : {2, 0, 1}) {
    Json result = Result();
    result["metrics"][1]["value"] = 0.1 * (seed + 1);
    suite_.Add(result, "static", seed);
  }
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(1));
  const Cell& cell = table.rows[0].cells[1];
  EXPECT_NEAR(*cell.value, 0.2, 1e-15);
  EXPECT_EQ(cell.n.seeds, 3U);
  EXPECT_EQ(cell.n.scenes, 1U);
  ASSERT_TRUE(cell.interval.has_value());
  EXPECT_EQ(cell.interval->low, 0.1);
  EXPECT_NEAR(cell.interval->high, 0.3, 1e-15);
}

TEST_F(MakeTableTest, ScenesHaveEqualWeightRegardlessOfSeeds) {
  suite_.table["rows"] = {"variant"};
  for (const int seed : {0, 1, 2}) {
    Json result = Result("a");
    result["metrics"][1]["value"] = 1.0;
    suite_.Add(result, "static", seed);
  }
  Json result = Result("b");
  result["metrics"][1]["value"] = 2.0;
  suite_.Add(result, "static", 0);
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(1));
  EXPECT_DOUBLE_EQ(*table.rows[0].cells[1].value, 1.5);
  EXPECT_FALSE(table.rows[0].sequence.has_value());
}

TEST_F(MakeTableTest, ARowMayBeComparedWithTheRowAbove) {
  suite_.table["rows"] = {"sequence", "variant"};
  suite_.table["reference"] = "the row above";
  for (const char* scene : {"a", "b"}) {
    for (const char* variant : {"static", "2d", "full"}) {
      Json result = Result(scene);
      result["metrics"][1]["value"] = std::string(variant).size();
      suite_.Add(result, variant, 0);
    }
  }
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(6));
  EXPECT_FALSE(table.rows[0].cells[1].difference);
  EXPECT_EQ(table.rows[1].cells[1].difference.value().difference, -4.0);
  EXPECT_EQ(table.rows[2].cells[1].difference.value().difference, 2.0);
  EXPECT_EQ(table.reference, "the row above");
  EXPECT_FALSE(table.rows[3].cells[1].difference) << "the row above is of another scene";
}

TEST_F(MakeTableTest, RowsFollowTheKeysAndOrderOfTheSuite) {
  suite_.table["rows"] = {"window.spatial", "oracle"};
  suite_.Add(Result("a"))["parameters"] = {{"window.spatial", 9}};
  suite_.Add(Result("a"))["parameters"] = {{"window.spatial", 5}};
  Json given = Result("a");
  given["given"] = {{"oracle", {"boxes", "labels"}}};
  suite_.Add(given)["oracle"] = {"labels", "boxes"};
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(3));
  EXPECT_THAT(table.rows[0].keys, ElementsAre("9", "none"));
  EXPECT_THAT(table.rows[1].keys, ElementsAre("5", "none"));
  EXPECT_THAT(table.rows[2].keys, ElementsAre("default", "labels,boxes"));
}

TEST_F(MakeTableTest, ReportsPooledKeys) {
  suite_.table["rows"] = {"variant"};
  suite_.Add(Result("a"));
  suite_.Add(Result("a"))["detections"] = "poor";
  EXPECT_THAT(Make().notes, ElementsAre("rows are means over detections: good, poor"));
  suite_.table["rows"] = {"variant", "detections"};
  EXPECT_THAT(Make().notes, Each(Not(StartsWith("rows are means"))));
}

TEST_F(MakeTableTest, MissingRunsAreCountedAndReported) {
  suite_.table["rows"] = {"variant"};
  suite_.Add(Result("a"));
  suite_.Plan("b", "static");
  suite_.AddFailure("stopped after 600 s");
  suite_.Plan("c", "static");
  Json& missing = suite_.Plan("d", "static");
  missing["job"] = "";
  missing["missing"] = "/data/d: no such folder";
  Json& drawn_later = suite_.Plan("e", "static");
  drawn_later["job"] = "";
  drawn_later["missing"] = "not rendered yet";
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(1));
  EXPECT_EQ(table.rows[0].jobs.planned, 5U);
  EXPECT_EQ(table.rows[0].jobs.done, 1U);
  EXPECT_EQ(table.jobs.failed, 1U);
  EXPECT_EQ(table.jobs.not_run, 2U);
  EXPECT_EQ(table.jobs.no_data, 1U);
  ASSERT_THAT(table.problems, SizeIs(4));
  EXPECT_EQ(table.problems[0].message, "stopped after 600 s");
  EXPECT_EQ(table.problems[0].log, "logs/x.log");
  EXPECT_EQ(table.problems[3].state, "no data");
  EXPECT_EQ(table.problems[3].message, "/data/d: no such folder");
  EXPECT_EQ(table.rows[0].cells[1].n.runs, 1U);
  EXPECT_FALSE(IsComplete(table));
}

TEST_F(MakeTableTest, MissingSequencesAreNotFatalUnlessAllAreMissing) {
  Json& missing = suite_.Plan("d", "static");
  missing["job"] = "";
  missing["missing"] = "no such folder";
  EXPECT_THAT(Make().columns, IsEmpty());
  EXPECT_FALSE(IsComplete(Make()));
  suite_.Add(Result("a"));
  EXPECT_TRUE(IsComplete(Make()));
}

TEST_F(MakeTableTest, ALostRunKeepsItsValuesAndIsCounted) {
  Json lost = Result();
  lost["status"] = "lost";
  lost["message"] = "3 frames predicted";
  suite_.Add(lost);
  const Table table = Make();
  EXPECT_EQ(table.jobs.lost, 1U);
  EXPECT_EQ(table.problems[0].message, "3 frames predicted");
  EXPECT_TRUE(table.rows[0].cells[1].value);
  EXPECT_TRUE(IsComplete(table));
}

TEST_F(MakeTableTest, ResultsThatCannotBeReadAreFailures) {
  suite_.table["rows"] = {"variant"};
  suite_.Add(Result("good"));
  const auto add = [this](const std::string& text) {
    suite_.Plan("bad", "static", static_cast<int>(text.size()));
    suite_.AddText(text);
  };
  Json other_job = Result();
  add(other_job.dump());
  const std::string whole = Result().dump();
  for (const std::size_t cut : {whole.size() - 1, whole.size() - 30, std::size_t{300}}) {
    add(whole.substr(0, cut));
  }
  Json newer = Result();
  newer["schema_version"] = 4;
  add(newer.dump());
  add(R"({"schema_version": 3, "kind": "timing"})");
  Json nameless = Result();
  nameless["sequence"].erase("name");
  add(nameless.dump());
  Json textual = Result();
  textual["metrics"][0]["value"] = "1.0";
  add(textual.dump());
  add("");
  const Table table = Make();
  ASSERT_THAT(table.problems, SizeIs(9));
  const auto message = [&table](std::size_t i) { return table.problems[i].message; };
  EXPECT_THAT(message(0), HasSubstr("the result of job \"job of"));
  EXPECT_THAT(message(1), HasSubstr("text that ends after"));
  EXPECT_THAT(message(2), HasSubstr("text that ends after"));
  EXPECT_THAT(message(3), HasSubstr("result.json: found text that ends after 300 bytes"));
  EXPECT_THAT(message(4), HasSubstr("found schema_version 4, expected 3"));
  EXPECT_THAT(message(5), HasSubstr("kind \"timing\""));
  EXPECT_THAT(message(6), HasSubstr("sequence, field name: found nothing"));
  EXPECT_THAT(message(7), HasSubstr("metrics[0], field value: found a JSON string"));
  EXPECT_THAT(message(8), HasSubstr("an empty file"));
  EXPECT_EQ(table.rows[0].jobs.done, 1U);
}

TEST_F(MakeTableTest, BadPlansAreRefused) {
  EXPECT_THAT(MakeError(), HasSubstr("field jobs: found none"));
  suite_.Add(Result());
  const auto file = suite_.Written() / "plan.json";
  const std::string whole = test::ReadFile(file);
  const auto error = [&](const std::string& text) {
    suite_.folder().Write("plan.json", text);
    return ErrorMessage([&] { MakeTable(suite_.folder().path(), {}, ""); });
  };
  EXPECT_EQ(error(whole), "");
  EXPECT_THAT(error(whole.substr(0, whole.size() / 2)), HasSubstr("plan.json: found text that"));
  EXPECT_THAT(error(R"({"schema_version": 9, "kind": "plan"})"), HasSubstr("schema_version 9"));
  EXPECT_THAT(error(R"({"schema_version": 1, "kind": "run"})"), HasSubstr("kind \"run\""));
  EXPECT_THROW(MakeTable(suite_.folder().path() / "jobs", {}, ""), Error);
}

TEST_F(MakeTableTest, OtherContractsAreRefusedNamingBothAndTheField) {
  suite_.Add(Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["contract"]["alignment"] = "none";
  suite_.Add(other);
  EXPECT_THAT(MakeError(), AllOf(HasSubstr("metric camera_ate"),
                                 HasSubstr("job0/result.json with alignment \"SE"),
                                 HasSubstr("job1/result.json with alignment \"none\"")));
}

TEST_F(MakeTableTest, AContractWithoutAFieldAndAnotherUnitAreRefused) {
  suite_.Add(Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["contract"].erase("poses");
  suite_.Add(other);
  EXPECT_THAT(MakeError(), HasSubstr("job1/result.json with poses \"\""));
  SuiteResults units;
  units.Add(Result());
  Json cm = Result("b");
  cm["metrics"][1]["unit"] = "rad";
  units.Add(cm);
  EXPECT_THROW(MakeTable(units.Written(), {}, ""), Error);
}

TEST_F(MakeTableTest, TheTruthMayDifferBetweenDatasetsOnly) {
  suite_.Add(Result());
  Json odometry = Result("odometry_06", 51);
  odometry["sequence"]["type"] = "kitti-odometry";
  for (Json& metric : odometry["metrics"]) metric["contract"]["truth"] = "official";
  suite_.Add(odometry);
  EXPECT_EQ(Make().rows[1].truth.truth, TruthSource::kOfficial);
  Json official = Result("2011_09_26_drive_0013");
  for (Json& metric : official["metrics"]) metric["contract"]["truth"] = "official";
  suite_.Add(official);
  EXPECT_THAT(MakeError(), AllOf(HasSubstr("job0/result.json with truth \"devkit\""),
                                 HasSubstr("job2/result.json with truth \"official\"")));
}

TEST_F(MakeTableTest, ContractsOverAllFramesOfTheirRunAreEqual) {
  for (const int frames : {108, 72}) {
    Json result = Result("drive of " + std::to_string(frames), frames);
    result["metrics"][1]["contract"]["frames"] = {{"first", 0}, {"last", frames - 1}};
    suite_.Add(result);
  }
  EXPECT_EQ(Make().columns[1].contract.frames, kFramesOfRun);
  Json part = Result("part", 72);
  part["metrics"][1]["contract"]["frames"] = {{"first", 0}, {"last", 9}};
  suite_.Add(part);
  EXPECT_THAT(MakeError(), HasSubstr("with frames \"{\"first\":0,\"last\":9}\""));
}

TEST_F(MakeTableTest, OtherSystemsMayHaveAnotherContract) {
  suite_.Add(Result());
  Json other = Result();
  other["metrics"][1]["contract"]["matching"] = "nearness";
  suite_.Add(other, "system:ORB-SLAM2")["system"] = "ORB-SLAM2";
  suite_.table["reference"] = "static";
  const Table table = Make();
  EXPECT_THAT(table.rows[1].keys, ElementsAre("2011_09_26_drive_0001", "ORB-SLAM2"));
  EXPECT_EQ(table.rows[1].cells[1].not_comparable, "matching \"nearness\"");
  EXPECT_FALSE(table.rows[1].cells[1].difference);
  EXPECT_TRUE(table.rows[1].cells[0].not_comparable.empty());
  EXPECT_TRUE(table.rows[1].cells[0].difference);
  EXPECT_TRUE(table.rows[0].cells[1].not_comparable.empty());
}

TEST_F(MakeTableTest, ProvenanceNamesBuildsSeedsAndChangedOptions) {
  suite_.Add(Result());
  Json other = Result("b");
  other["options"]["orb"]["features"] = 1000;
  other["build"]["identity"] = "xyz";
  suite_.Add(other, "static", 7);
  const Table table = Make(R"({"orb": {"features": 2000, "levels": 8}})");
  EXPECT_THAT(table.provenance.builds, ElementsAre("abc", "xyz"));
  EXPECT_THAT(table.provenance.seeds, ElementsAre(0, 7));
  ASSERT_THAT(table.provenance.options, SizeIs(1));
  EXPECT_EQ(table.provenance.options[0].path, "orb.features");
  EXPECT_EQ(table.provenance.options[0].default_value, "2000");
  EXPECT_THAT(table.provenance.options[0].values, ElementsAre("1000"));
  EXPECT_THAT(table.notes, ElementsAre(HasSubstr("2 builds")));
}

TEST_F(MakeTableTest, MissingMetricsAreReported) {
  suite_.Add(Result());
  Json coverage_only = Result("2011_09_26_drive_0013");
  coverage_only["metrics"].erase(1);
  suite_.Add(coverage_only);
  Json none = Result("2011_09_26_drive_0014");
  none.erase("metrics");
  suite_.Add(none);
  const Table table = Make();
  EXPECT_TRUE(table.rows[1].cells[0].value);
  EXPECT_FALSE(table.rows[1].cells[1].value);
  EXPECT_EQ(table.rows[1].cells[1].message, "no value in the run");
  EXPECT_FALSE(table.rows[2].cells[0].value);
}

TEST_F(MakeTableTest, AReferenceMustBeOneOfTheRows) {
  suite_.Add(Result());
  suite_.table["reference"] = "static";
  EXPECT_FALSE(Make().rows[0].cells[1].difference) << "not compared with itself";
  suite_.table["rows"] = {"sequence"};
  EXPECT_THAT(MakeError(), HasSubstr("table, reference: found static"));
}

TEST(WithCoverage, AccuracyIsShownWithCoverage) {
  EXPECT_THAT(WithCoverage({"object_ate", "object_ate", "moving_recall"}),
              ElementsAre("object_coverage", "object_ate", "moving_recall"));
  EXPECT_THAT(WithCoverage({"object_success_10cm", "object_coverage"}),
              ElementsAre("object_success_10cm", "object_coverage"));
  EXPECT_THAT(WithCoverage({"object_causal_standing_ate", "camera_ate"}),
              ElementsAre("object_causal_standing_coverage", "object_causal_standing_ate",
                          "camera_coverage", "camera_ate"));
}

}  // namespace
}  // namespace cvo::reports
