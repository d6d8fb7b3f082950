// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "reports/tables/make_table.h"
#include "tests/reports/results/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using test::Result;
using testing::HasSubstr;
using testing::SizeIs;

Table TableOf(const Json& result) {
  test::SuiteResults suite;
  suite.Add(result);
  return MakeTable(suite.Written(), ShippedReference(), "");
}

// Returns the ATE of a system from a source; fails the test if the table does not have it.
ReferenceCell Ate(const Table& table, const std::string& system, const std::string& source) {
  for (const ReferenceRow& line : table.rows[0].reference) {
    const ReferenceCell* cell = line.Find(table.columns[1]);
    if (line.system == system && line.source == source && cell != nullptr) return *cell;
  }
  ADD_FAILURE() << "no ATE of " << system << " from " << source;
  return {};
}

// Only drifts of the camera: those of single bodies appear in figures alone.
TEST(Reference, ListsMaximumDriftsOfOtherSystems) {
  Json result = Result("swinging_4_unconstrained", 500);
  for (const char* name : {"camera_max_drift_first25", "camera_max_drift"}) {
    result["metrics"].push_back(test::MetricOf(
        name, 0.1, "m", "maximum of translation errors; of several bodies their mean"));
    result["metrics"].back()["contract"]["alignment"] = NameOf(Alignment::kFirstMotions);
  }
  test::SuiteResults suite;
  suite.table["metrics"] = {"camera_max_drift_first25", "camera_max_drift"};
  suite.Add(result);
  const Table table = MakeTable(suite.Written(), ShippedReference(), "");
  ASSERT_THAT(table.rows[0].reference, SizeIs(3));
  const ReferenceRow& mvo = table.rows[0].reference[0];
  EXPECT_EQ(mvo.system, "MVO");
  const ReferenceCell* drift = mvo.Find(table.columns[1]);
  ASSERT_TRUE(drift);
  EXPECT_EQ(drift->value, 0.21);
  EXPECT_EQ(drift->match, Match::kContractUnknown) << drift->reason;
  EXPECT_THAT(FindBy(table.sources, &ReferenceSource::id, mvo.source)->caveat,
              HasSubstr("sources disagree"));
}

TEST(Reference, ShippedFilesHoldTheFacts) {
  std::set<std::string> sources;
  double found = 0.0;
  for (const ReferenceFigure& figure : ShippedReference()) {
    sources.insert(figure.source.id);
    EXPECT_EQ(figure.suite.empty(), figure.frames > 0);
    if (figure.system == "MVO" && figure.body == "bottom left" &&
        figure.metric == "object_max_drift_first25_yaw") {
      EXPECT_DOUBLE_EQ(figure.value, 0.05498) << "3.15 degrees";
    }
    if (figure.sequence == "2011_09_26_drive_0013" && figure.system == "ClusterVO" &&
        figure.metric == "camera_ate") {
      EXPECT_EQ(figure.frames, 144);
      found = figure.value;
    }
  }
  EXPECT_EQ(found, 0.26);
  EXPECT_THAT(sources, SizeIs(10));
}

TEST(Reference, MeasuredFiguresCompareOnTheirFrames) {
  const Table table = TableOf(Result("2011_09_26_drive_0001", 108));
  const ReferenceCell cell = Ate(table, "ORB-SLAM2", "measured-upstream");
  EXPECT_EQ(cell.value, 0.071);
  EXPECT_EQ(cell.match, Match::kMatches) << cell.reason;
  EXPECT_EQ(table.sources[0].source, "measured by us with upstream code, grey images");
}

TEST(Reference, MeasuredFiguresOfOdometryAreAgainstTheOfficialTruth) {
  Json result = Result("odometry_06", 51);
  for (Json& metric : result["metrics"]) metric["contract"]["truth"] = "official";
  EXPECT_EQ(Ate(TableOf(result), "libviso2", "measured-upstream").match, Match::kMatches);
}

TEST(Reference, FiguresNeedTheSameCorrectionOfTheCalibration) {
  Json corrected = Result("2011_09_26_drive_0001", 108);
  for (Json& metric : corrected["metrics"]) {
    metric["contract"]["right_shift_px"] = 0.16;
  }
  const Table with = TableOf(corrected);
  const ReferenceCell published = Ate(with, "ORB-SLAM2", "measured-upstream");
  EXPECT_EQ(published.match, Match::kContractDiffers);
  EXPECT_EQ(published.reason, "right_shift_px differs");
  EXPECT_EQ(Ate(with, "ORB-SLAM2", "measured-upstream-corrected").match, Match::kMatches);
  const Table without = TableOf(Result("2011_09_26_drive_0001", 108));
  EXPECT_EQ(Ate(without, "ORB-SLAM2", "measured-upstream-corrected").match,
            Match::kContractDiffers);
}

TEST(Reference, WholeDriveFiguresNeedTheWholeDrive) {
  const Table part = TableOf(Result("2011_09_26_drive_0013", 72));
  const ReferenceCell other = Ate(part, "ClusterVO", "clustervo-table-2");
  EXPECT_EQ(other.value, 0.26);
  EXPECT_EQ(other.match, Match::kOtherFrames);
  EXPECT_EQ(other.reason, "frames 0:144, ours 0:72");
  EXPECT_EQ(Ate(part, "ORB-SLAM2", "measured-upstream").match, Match::kMatches);
  const Table whole = TableOf(Result("2011_09_26_drive_0013", 144));
  const ReferenceCell same = Ate(whole, "ClusterVO", "clustervo-table-2");
  EXPECT_EQ(same.match, Match::kMatches);
  EXPECT_THAT(same.reason, HasSubstr("inferred"));
  EXPECT_EQ(Ate(whole, "ORB-SLAM2", "measured-upstream").match, Match::kOtherFrames);
}

TEST(Reference, ComparableFiguresComeFirst) {
  const Table table = TableOf(Result("2011_09_26_drive_0013", 72));
  EXPECT_EQ(table.rows[0].reference[0].system, "ORB-SLAM2");
  EXPECT_EQ(table.rows[0].reference[0].frames, 72);
}

TEST(Reference, AContractThatIsNotStatedDoesNotMatch) {
  const Table table = TableOf(Result("2011_09_26_drive_0013", 144));
  const ReferenceCell cell = Ate(table, "DynaSLAM II", "dynaslam2-table-2");
  EXPECT_EQ(cell.match, Match::kContractUnknown);
  EXPECT_THAT(cell.reason, HasSubstr("not stated: poses, truth, alignment"));
}

TEST(Reference, AnotherContractOrOtherImagesDoNotMatch) {
  Json official = Result();
  for (Json& metric : official["metrics"]) metric["contract"]["truth"] = "official";
  const ReferenceCell truth = Ate(TableOf(official), "ORB-SLAM2", "measured-upstream");
  EXPECT_EQ(truth.match, Match::kContractDiffers);
  EXPECT_EQ(truth.reason, "truth differs");
  Json colour = Result();
  colour["sequence"]["pair"] = "colour";
  const ReferenceCell pair = Ate(TableOf(colour), "ORB-SLAM2", "measured-upstream");
  EXPECT_EQ(pair.match, Match::kOtherImages);
  Json causal = Result();
  causal["metrics"][1]["contract"]["poses"] = "causal";
  EXPECT_EQ(Ate(TableOf(causal), "ORB-SLAM2", "measured-upstream").match, Match::kContractDiffers);
}

TEST(Reference, FiguresOfASuiteAreListedBelowIt) {
  const Reference reference = ShippedReference();
  test::SuiteResults suite;
  suite.table["metrics"] = {"camera_ate"};
  suite.Add(Result("indoor_1"));
  Table table = MakeTable(suite.Written(), reference, "");
  EXPECT_THAT(table.others, SizeIs(0)) << "a suite of another name";
  suite.name = "ablation_all";
  table = MakeTable(suite.Written(), reference, "");
  ASSERT_THAT(table.others, SizeIs(6));
  EXPECT_EQ(table.others[3].system, "ClusterVO 2D");
  const ReferenceCell* ate = table.others[3].Find(table.columns[1]);
  ASSERT_TRUE(ate);
  EXPECT_DOUBLE_EQ(ate->value, 0.0062) << "printed times 100";
  EXPECT_EQ(ate->match, Match::kOtherScenes);
  EXPECT_THAT(table.sources[0].caveat, HasSubstr("order"));
}

TEST(Reference, BadFilesNameTheField) {
  Reference reference;
  const auto error = [&reference](const std::string& text) {
    return ErrorMessage([&] { AddReference(text, "file", reference); });
  };
  EXPECT_THAT(error("{"), HasSubstr("file: found text that ends"));
  EXPECT_THAT(error(R"({"schema_version": 7, "kind": "reference"})"),
              HasSubstr("schema_version 7"));
  EXPECT_THAT(error(R"({"schema_version": 2, "kind": "reference", "sources": [{"id": "x"}]})"),
              HasSubstr("field source: found nothing"));
  const auto with_contract = [](const std::string& contract) {
    return R"({"schema_version": 2, "kind": "reference", "sources": [{"id": "x", "source": "", "kind": "", "caveat": "",)"
           R"( "metrics": {"camera_ate": {"unit": "m", "contract": )" +
           contract +
           R"(}}, "figures": [{"suite": "s", "system": "x", "values": {"camera_ate": 1.0}}]}]})";
  };
  EXPECT_EQ(error(with_contract(R"({"delta": "all", "poses": null})")), "");
  EXPECT_THAT(error(with_contract(R"({"detla": "all"})")),
              HasSubstr("found detla, expected a field of a contract"));
  EXPECT_THAT(error(with_contract(R"({"delta": "every"})")),
              HasSubstr("field delta: found \"every\", expected one of \"none\", \"all\""));
}

}  // namespace
}  // namespace cvo::reports
